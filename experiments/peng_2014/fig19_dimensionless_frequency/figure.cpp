#include <fmt/format.h>

#include <cmath>

#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/carnahan_starling_1969.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

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
  output.caption = fmt::format(
      "Collision frequency of the 6 mm steel sphere in 5 mm glass, made dimensionless with the diameter and the "
      "fluctuating energy of the fluidised spheres (Eq. 38), against the solid fraction. Dashed black: the kinetic "
      "theory as the paper evaluates it (Eqs. 6 and 7, packed solid fraction {}). Thin green: the same with Carnahan "
      "and "
      "Starling's contact value. Black bars: the two frequencies that the paper prints, {} 1/s at {} and {} 1/s at "
      "0.42, "
      "over what its axes allow for the fluctuating energy (Fig. 18) and with 5 or 6 mm as the diameter. Filled "
      "symbols: "
      "our runs with 95 % intervals. The paper's points are not available as numbers.",
      printed.value("packed_solid_fraction"), printed.value("collision_frequency_dense"),
      printed.value("size_independence"), printed.value("collision_frequency_dilute"));

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

  const std::string simulated =
      plot_variants_against_bed("dimensionless_collision_frequency", "dimensionless collision frequency [-]",
                                system_name, BedAbscissa::solid_fraction, context, output);
  const std::string script =
      "set key tmargin left vertical maxrows 7 Left reverse font ',12'\nset xrange [0.15:0.6]\nset logscale y\n"
      "set yrange [1:1000]\nset xlabel 'solid fraction α_S [-]'\nset ylabel 'dimensionless collision frequency f* "
      "[-]'\n"
      "plot 'fig19_kinetic_theory.csv' skip 1 using 1:2 with lines linestyle 1 title 'kinetic theory, Eqs. 6 and 7', "
      "'' skip 1 using 1:3 with lines linestyle 12 title 'kinetic theory, Carnahan-Starling', "
      "'fig19_paper.csv' skip 1 using 1:2:1:1:3:4 with xyerrorbars linecolor rgb paper linewidth 1.6 pointsize 0 title "
      "'printed "
      "frequencies, range the axes allow'" +
      simulated + "\n";
  draw_figure_of_runs("fig19", script, {520, 480}, context, keys, own_springs);
  return output;
}

}  // namespace

Figure fig19() {
  return {"fig19", "Dimensionless collision frequency and the kinetic theory", needs, draw,
          "peng_2014/fig19_dimensionless_frequency"};
}

}  // namespace slfb
