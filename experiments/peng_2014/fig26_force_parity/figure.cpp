#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"

namespace slfb::fig26_force_parity {
namespace {

const FigureFolder folder{"peng_2014/fig26_force_parity"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.variant.empty() && spec.superficial_velocity > 0.015 &&
           std::any_of(bed_systems.begin(), bed_systems.end(),
                       [&](const BedSystem& system) { return system.name == spec.system; });
  });
}

double equation_40(double voidage) { return collision::Peng2014{}(paper::steel_in_glass(0.0, voidage), 0.0); }

/// Simulated force against Eq. 40 at the simulated voidage, whose interval becomes one of the prediction.
DataTable parity(const FigureContext& context, const BedSystem& system) {
  DataTable table{fmt::format("fig26_{}", system.name),
                  {"superficial velocity [m/s]", "voidage [-]", "Eq. 40 [-]", "half width of its 95 % interval [-]",
                   "simulated force over weight [-]", "half width of its 95 % interval [-]"},
                  {}};
  for (const auto& row :
       against_bed(context, "collision_force_ratio", "", system.name, "", BedAbscissa::voidage).rows) {
    const double slope = (equation_40(row[1] + 1e-4) - equation_40(row[1] - 1e-4)) / 2e-4;
    table.rows.push_back({row[0], row[1], equation_40(row[1]), std::fabs(slope) * row[2], row[3], row[4]});
  }
  return table;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig26", {}, "", run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::force_ratio, grid_convergence::voidage}, context, output);
  std::vector<Series> simulated;
  double sum = 0.0, squares = 0.0;
  int points = 0, within_10 = 0, within_20 = 0;
  for (const BedSystem& system : bed_systems) {
    DataTable table = parity(context, system);
    for (const auto& row : table.rows) {
      const double deviation = row[4] / row[2] - 1.0;
      sum += deviation;
      squares += deviation * deviation;
      ++points;
      within_10 += std::fabs(deviation) <= 0.1 ? 1 : 0;
      within_20 += std::fabs(deviation) <= 0.2 ? 1 : 0;
    }
    simulated.push_back({std::move(table), std::string(system.title), system.line_style});
  }
  output.caption = folder.caption(
      {{"agreement",
        points == 0
            ? ""
            : fmt::format("Of our {} points {} lie within 10 % and {} within 20 %; mean deviation {:+.1f} %, "
                          "root mean square {:.1f} %.",
                          points, within_10, within_20, 100.0 * sum / points, 100.0 * std::sqrt(squares / points))}});
  PlotValues values;
  add_series("simulated", simulated, values, context, output);
  draw_plot_of_runs("fig26", folder.plot(), values, {540, 560}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig26", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig26_force_parity
