#include "experiments/richardson_zaki_1954/work.hpp"

#include <fmt/format.h>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/league/league_report.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"
#include "experiments/richardson_zaki_1954/figures.hpp"
#include "experiments/richardson_zaki_1954/numbers.hpp"
#include "experiments/richardson_zaki_1954/simulations.hpp"
#include "solver/support/files.hpp"

namespace slfb {
namespace {

namespace rz = richardson_zaki;

reports::WorkTexts texts() {
  reports::WorkTexts all;
  all.title = "Expansion of measured fluidised beds";
  all.introduction =
      "Eleven beds that Richardson and Zaki (1954) measured: spheres of steel, glass and lead in water, glycerol–water "
      "and oils, in columns of 62 and 38 mm, beside our simulations and every drag law of the suite.";
  all.about_figures = "Points are simulations, black lines are measured.";
  all.methods = read_file(folders_of("richardson_zaki_1954").experiments / "README.md");
  return all;
}

Work rz_put_together() {
  Work work;
  work.id = "richardson_zaki_1954";
  work.citation =
      "J. F. Richardson, W. N. Zaki, Sedimentation and fluidisation: Part I, Transactions of the Institution of "
      "Chemical Engineers 32, 35-53 (1954)";
  work.folders = folders_of(work.id);
  for (const ExpansionLine& line : rz::beds())
    work.systems.push_back({line.name, fmt::format("{:g} mm {} in {}, column of {:g} mm", 1e3 * line.sphere.diameter,
                                                   line.particle, line.liquid_name, 1e3 * line.tube_diameter)});
  for (Quantity& quantity : rz::own_quantities()) work.measuring.quantities.push_back(std::move(quantity));
  work.reference = &rz::printed();
  work.figures = {rz::expansion::figure(), rz::parity::figure(), rz::deviation::figure(),
                  rz::three_dimensions::figure(), league::figure()};
  work.read_by_figures = {"laws"};
  work.without_runs = rz::measure_laws;
  work.shown_beside = "full";
  work.profiles = rz::profiles;
  work.claims = rz::claims;
  work.texts = texts;
  return work;
}

}  // namespace

const Work& richardson_zaki_1954_work() {
  static const Work work = rz_put_together();
  return work;
}

}  // namespace slfb
