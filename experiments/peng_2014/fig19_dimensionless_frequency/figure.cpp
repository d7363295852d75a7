#include <fmt/format.h>

#include <cmath>

#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/carnahan_starling_1969.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"

namespace slfb::fig19_dimensionless_frequency {
namespace {

const FigureFolder folder{"peng_2014/fig19_dimensionless_frequency"};
constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

/// f* of the kinetic theory (Eq. 6), which depends on the solid fraction and the contact value alone.
double kinetic_theory(double solids, double contact_value) {
  const collision::CollisionState state{.solids = solids,
                                        .bed_diameter = 0.005,
                                        .foreign_diameter = 0.005,
                                        .kinetic_energy = 1e-3,
                                        .contact_value = contact_value};
  return collision::dimensionless_frequency(collision::Simonin1991{}(state), state);
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig19", {}, "", run_notes(context, keys)};
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  output.caption =
      folder.caption({{"packed", fmt::format("{}", printed.value("packed_solid_fraction"))},
                      {"dense_frequency", fmt::format("{}", printed.value("collision_frequency_dense"))},
                      {"dense_fraction", fmt::format("{}", printed.value("size_independence"))},
                      {"dilute_frequency", fmt::format("{}", printed.value("collision_frequency_dilute"))}});

  DataTable theory{
      "fig19_kinetic_theory", {"solid fraction [-]", "Eqs. 6 and 7 [-]", "Eq. 6 with Carnahan-Starling [-]"}, {}};
  for (int step = 10; step <= 114; ++step) {
    const double solids = 0.005 * step;
    theory.rows.push_back({solids, kinetic_theory(solids, collision::LunSavage1986{}(solids)),
                           kinetic_theory(solids, collision::CarnahanStarling1969{}(solids))});
  }
  output.data.push_back(write_csv(theory, context.out));

  DataTable bars{"fig19_paper", {"solid fraction [-]", "middle [-]", "lowest [-]", "highest [-]"}, {}};
  for (const auto& [solids, id] : {std::pair{printed.value("size_independence"), "collision_frequency_dense"},
                                   std::pair{0.42, "collision_frequency_dilute"}}) {
    const double lowest = printed.value(id) * 0.005 / std::sqrt(printed.value("fluctuating_energy_highest"));
    const double highest = printed.value(id) * 0.006 / std::sqrt(printed.value("fluctuating_energy_lowest"));
    bars.rows.push_back({solids, std::sqrt(lowest * highest), lowest, highest});
  }
  output.data.push_back(write_csv(bars, context.out));

  PlotValues values;
  add_series("simulated",
             variants_against_bed("fig19", "dimensionless_collision_frequency", "dimensionless collision frequency [-]",
                                  system_name, BedAbscissa::solid_fraction, context),
             values, context, output);
  draw_plot_of_runs("fig19", folder.plot(), values, {520, 480}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig19", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig19_dimensionless_frequency
