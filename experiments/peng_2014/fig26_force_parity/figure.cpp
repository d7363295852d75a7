#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"

namespace slfb {
namespace {

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
  std::string simulated;
  double sum = 0.0, squares = 0.0;
  int points = 0, within_10 = 0, within_20 = 0;
  for (const BedSystem& system : bed_systems) {
    const DataTable table = parity(context, system);
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, context.out));
    for (const auto& row : table.rows) {
      const double deviation = row[4] / row[2] - 1.0;
      sum += deviation;
      squares += deviation * deviation;
      ++points;
      within_10 += std::fabs(deviation) <= 0.1 ? 1 : 0;
      within_20 += std::fabs(deviation) <= 0.2 ? 1 : 0;
    }
    simulated += fmt::format(", {}{}'{}.csv' skip 1 using 3:5 with points linestyle {} title '{}'",
                             error_bars(table, {3, 5, 6}, "yerrorbars", system.line_style),
                             error_bars(table, {3, 5, 4}, "xerrorbars", system.line_style), table.name,
                             system.line_style, system.title);
  }
  output.caption =
      "Simulated mean collision force over weight against Eq. 40 at the voidage of the simulated bed, for eight pairs "
      "of "
      "foreign and fluidised sphere; 95 % intervals both ways. Solid: equality; dashed and dotted: 10 and 20 %, within "
      "which the paper finds most and all of its points. Its points are not available as numbers.";
  if (points > 0)
    output.caption += fmt::format(
        " Of our {} points {} lie within 10 % and {} within 20 %; mean deviation {:+.1f} %, root mean square {:.1f} %.",
        points, within_10, within_20, 100.0 * sum / points, 100.0 * std::sqrt(squares / points));
  const std::string script =
      "set key tmargin left vertical maxrows 5 Left reverse font ',11'\nset xrange [0.3:1.1]\nset yrange [0.3:1.1]\n"
      "set xtics 0.2\nset ytics 0.2\nset size ratio -1\nset xlabel '|F_c|/mg by Eq. 40 [-]'\n"
      "set ylabel 'simulated |F_c|/mg [-]'\n"
      "plot x with lines linecolor rgb paper linewidth 1.2 title 'equality', 0.9*x with lines linestyle 1 linewidth 1 "
      "title "
      "'10 %', 1.1*x with lines linestyle 1 linewidth 1 notitle, 0.8*x with lines linestyle 20 linecolor rgb paper "
      "title '20 "
      "%', 1.2*x with lines linestyle 20 linecolor rgb paper notitle" +
      simulated + "\n";
  draw_figure_of_runs("fig26", script, {540, 560}, context, keys);
  return output;
}

}  // namespace

Figure fig26() {
  return {"fig26", "Collision force of eight systems against Eq. 40", needs, draw, "peng_2014/fig26_force_parity"};
}

}  // namespace slfb
