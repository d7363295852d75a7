#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/collision/collision_frequency/gjaltema_1997.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.variant.empty() && spec.superficial_velocity > 0.015 &&
           std::any_of(bed_systems.begin(), bed_systems.end(),
                       [&](const BedSystem& system) { return system.name == spec.system; });
  });
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig20", {}, "", run_notes(context, keys)};
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  output.caption =
      "Collision frequency of the foreign sphere against the solid fraction of the bed, for eight pairs of foreign and "
      "fluidised sphere: new contacts per second from entering the bed to the bottom, with 95 % intervals over the "
      "drops. Water: filled, sodium iodide solution: open. Open black circles: the two frequencies that the paper "
      "prints, without saying for which pair. Thin line: Eq. 5 for 6 mm in 5 mm, a straight flight at the velocity of "
      "Table 2 through the bed whose voidage Eq. 36 gives. The other points of the paper are not available as numbers.";

  const DataTable paper_points{"fig20_paper",
                               {"solid fraction [-]", "collision frequency [1/s]"},
                               {{printed.value("size_independence"), printed.value("collision_frequency_dense")},
                                {0.42, printed.value("collision_frequency_dilute")}}};
  output.data.push_back(write_csv(paper_points, context.out));
  DataTable flight{"fig20_straight_flight", {"solid fraction [-]", "collision frequency [1/s]"}, {}};
  for (const auto& row : printed.table2()) {
    const double solids = 1.0 - paper::steel_in_glass(row.superficial_velocity).voidage;
    flight.rows.push_back({solids, collision::Gjaltema1997{}({.solids = solids,
                                                              .bed_diameter = 0.005,
                                                              .foreign_diameter = 0.006,
                                                              .kinetic_energy = 0.0,
                                                              .relative_velocity = row.classification_velocity})});
  }
  output.data.push_back(write_csv(flight, context.out));

  std::string simulated;
  for (const BedSystem& system : bed_systems)
    simulated += plot_against_bed(against_bed(context, "collision_frequency", "collision frequency [1/s]", system.name,
                                              "", BedAbscissa::solid_fraction),
                                  std::string(system.title), system.line_style, context, output);
  const std::string script =
      "set key tmargin left vertical maxrows 5 Left reverse font ',11'\nset xrange [0.14:0.6]\nset logscale y\n"
      "set yrange [20:10000]\nset xlabel 'solid fraction α_S [-]'\nset ylabel 'collision frequency f_{coll} [1/s]' "
      "offset 1.8,0\n"
      "plot 'fig20_straight_flight.csv' skip 1 using 1:2 with lines linestyle 14 title 'Eq. 5 at V_2 of Table 2, 6 in "
      "5 "
      "mm', 'fig20_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, printed'" +
      simulated + "\n";
  draw_figure_of_runs("fig20", script, {560, 520}, context, keys, own_springs);
  return output;
}

}  // namespace

Figure fig20() {
  return {"fig20", "Collision frequency of eight systems", needs, draw, "peng_2014/fig20_collision_frequency"};
}

}  // namespace slfb
