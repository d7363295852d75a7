#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/collision/collision_frequency/gjaltema_1997.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"

namespace slfb::fig20_collision_frequency {
namespace {

const FigureFolder folder{"peng_2014/fig20_collision_frequency"};

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
  FigureOutput output{"fig20", {}, folder.caption(), run_notes(context, keys)};
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
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

  std::vector<Series> simulated;
  for (const BedSystem& system : bed_systems) {
    DataTable table = against_bed(context, "collision_frequency", "collision frequency [1/s]", system.name, "",
                                  BedAbscissa::solid_fraction);
    table.name = "fig20_" + table.name;
    simulated.push_back({std::move(table), std::string(system.title), system.line_style});
  }
  PlotValues values;
  add_series("simulated", simulated, values, context, output);
  draw_plot_of_runs("fig20", folder.plot(), values, {560, 520}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig20", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig20_collision_frequency
