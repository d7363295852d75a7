#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/run/one_particle.hpp"

namespace slfb {
namespace {

constexpr double superficial_velocity = 0.10;  // the one that the paper shows [m/s]

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.system == "6in5W" && spec.variant.empty() &&
           std::fabs(spec.superficial_velocity - superficial_velocity) < 1e-6;
  });
}

struct Panel {
  const char* title;
  int column;
  int fall_column;      // of the sphere alone in clear liquid; 0: not drawn
  double lower, upper;  // of the axis while nothing is simulated
};

constexpr std::array<Panel, 6> panel_list{{{"height z [m]", 2, 2, 0.0, 1.0},
                                           {"vertical velocity v_z [m/s]", 3, 3, -1.0, 0.0},
                                           {"angular speed |ω| [rad/s]", 4, 0, 0.0, 40.0},
                                           {"voidage at the sphere α_L [-]", 5, 0, 0.4, 1.0},
                                           {"vertical liquid velocity at the sphere u_z [m/s]", 6, 0, 0.0, 0.4},
                                           {"Reynolds number Re_p [-]", 7, 4, 0.0, 8000.0}}};

/// Mean height of the top of the bed over the second half of the time before the release.
std::optional<double> bed_top_before(const BedSeries& bed, double release_time) {
  double sum = 0.0;
  int samples = 0;
  for (std::size_t i = 0; i < bed.time.size() && bed.time[i] <= release_time; ++i) {
    if (bed.time[i] < 0.5 * release_time) continue;
    sum += bed.bed_top[i];
    ++samples;
  }
  if (samples == 0) return std::nullopt;
  return sum / samples;
}

/// The sphere alone in the clear liquid above the bed, by the one-particle equation, from `release_height` down to
/// `bed_top`: an independent check of the first two stages.
DataTable clear_liquid_fall(double release_height, double bed_top) {
  const Sphere steel = paper::steel(0.006);
  const LiquidProperties water = paper::water();
  OneParticleFall fall;
  fall.diameter = steel.diameter;
  fall.density = steel.density;
  fall.liquid_density = water.density;
  fall.viscosity = water.viscosity;
  fall.liquid_velocity = superficial_velocity;
  fall.surrounding_density = water.density;
  fall.height = release_height;
  std::vector<double> times;
  for (int step = 0; step <= 300; ++step) times.push_back(0.01 * step);
  DataTable table{
      "fig08_clear_liquid",
      {"time since release [s]", "height of the centre [m]", "vertical velocity [m/s]", "Reynolds number [-]"},
      {}};
  for (const auto& state : integrate_fall(fall, times)) {
    if (state.height < bed_top) break;
    const double slip = std::fabs(superficial_velocity - state.velocity);
    table.rows.push_back({state.time, state.height, state.velocity, reynolds_number(water, steel.diameter, slip)});
  }
  return table;
}

/// A step of 1, 2 or 5 times a power of ten that divides `extent` into two to four parts.
double tic_step(double extent) {
  const double power = std::pow(10.0, std::floor(std::log10(extent / 2.0)));
  for (const double factor : {5.0, 2.0})
    if (2.0 * factor * power <= extent) return factor * power;
  return power;
}

/// Six panels above each other that share the time axis. `entry` is the instant of entering the bed, not a number when
/// that is not known.
std::string panels(const DataTable& history, const DataTable& fall, double end, double entry) {
  const bool simulated = !history.rows.empty();
  std::string script = fmt::format(
      "set multiplot\nset lmargin at screen 0.125\nset rmargin at screen 0.97\nset xrange [0:{:.3f}]\n"
      "set format x ''\nset xtics {:.6g}\nbottom = base + 58.0/height\npitch = (1 - bottom)/6\n"
      "set label 5 'red: one sphere alone in clear liquid' at graph 0.99, 0.85 right font ',11' textcolor rgb "
      "law_one\n",
      end, tic_step(end));
  if (std::isfinite(entry))
    script += fmt::format(
        "set arrow 1 from {0:.4f}, graph 0 to {0:.4f}, graph 1 nohead linestyle 20\n"
        "set label 1 '  in the bed' at {0:.4f}, graph 0.12 font ',11' textcolor rgb quiet\n"
        "set label 2 'in liquid  ' at {0:.4f}, graph 0.12 right font ',11' textcolor rgb quiet\n",
        entry);
  for (std::size_t index = 0; index < panel_list.size(); ++index) {
    const auto& panel = panel_list[index];
    double lower = panel.lower, upper = panel.upper;
    if (simulated) {
      lower = std::numeric_limits<double>::infinity();
      upper = -lower;
      for (const auto& row : history.rows) {
        lower = std::min(lower, row[static_cast<std::size_t>(panel.column) - 1]);
        upper = std::max(upper, row[static_cast<std::size_t>(panel.column) - 1]);
      }
      if (panel.fall_column > 0)
        for (const auto& row : fall.rows) {
          lower = std::min(lower, row[static_cast<std::size_t>(panel.fall_column) - 1]);
          upper = std::max(upper, row[static_cast<std::size_t>(panel.fall_column) - 1]);
        }
    }
    const double step = tic_step(std::max(upper - lower, 1e-6));
    script += fmt::format(
        "set tmargin at screen 1 - {0}*pitch - 26.0/height\nset bmargin at screen 1 - {1}*pitch\n"
        "set label 3 '{2}' at graph 0, graph 1.12 font ',12'\nset yrange [{3:.6g}:{4:.6g}]\nset ytics {5:.6g}\n",
        index, index + 1, panel.title, step * std::floor(lower / step), step * std::ceil(upper / step), step);
    if (index + 1 == panel_list.size())
      script += "set format x '%g'\nset xlabel 'time since release [s]' offset 0,0.3\n";
    script += simulated
                  ? fmt::format("plot '{}.csv' skip 1 using 1:{} with lines linestyle 2 linewidth 1.3 notitle",
                                history.name, panel.column)
                  : "set label 4 'not yet simulated' at graph 0.5, 0.5 center textcolor rgb quiet\nplot NaN notitle";
    if (panel.fall_column > 0)
      script +=
          fmt::format(", '{}.csv' skip 1 using 1:{} with lines linestyle 11 notitle", fall.name, panel.fall_column);
    script += "\n";
    if (index == 0) script += "eval footer_drawn\nunset label 1\nunset label 2\nunset label 5\n";
  }
  return script + "unset multiplot\n";
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const std::string key = run_key("6in5W", superficial_velocity);
  const FinishedRun* run = find_run(context, key);
  if (run != nullptr && run->result.drops.empty()) run = nullptr;
  FigureOutput output{"fig08", {}, "", run_notes(context, keys)};
  output.caption =
      "First steel sphere (6 mm) released above the bed of 5 mm glass at U_L = 0.10 m/s: height, vertical and "
      "angular velocity, voidage and vertical liquid velocity at the sphere, and its Reynolds number (Eq. 25). It "
      "accelerates, falls steadily through clear liquid and then settles through the bed. The dotted line marks the "
      "instant at which its centre passes the mean top of the bed. Thin red: the same sphere alone in "
      "clear liquid that rises at U_L, by the one-particle equation with Wen and Yu's drag and no added mass. The "
      "curves of the paper are not available as "
      "numbers, so none is drawn.";
  double end = 4.0;  // of the time axis while nothing is simulated [s]
  double entry = std::numeric_limits<double>::quiet_NaN();
  double release_height = peng_2014().value("column_height") - 0.003;  // the whole sphere in the column [m]
  double bed_top = peng_2014().value("packed_height");
  DataTable table{
      "fig08_history",
      {"time since release [s]", "height of the centre [m]", "vertical velocity [m/s]", "angular speed [rad/s]",
       "voidage at the sphere [-]", "vertical liquid velocity at the sphere [m/s]", "Reynolds number [-]"},
      {}};
  if (run != nullptr) {
    const DropSeries& drop = run->result.drops.front();
    end = drop.bottom_time > 0.0 ? drop.bottom_time : drop.time.back();
    for (std::size_t i = 0; i < drop.time.size() && drop.time[i] <= end; ++i)
      table.rows.push_back({drop.time[i], drop.z[i], drop.velocity_z[i], drop.angular_speed[i], drop.voidage[i],
                            drop.liquid_velocity_z[i], drop.reynolds[i]});
    output.data.push_back(write_csv(table, context.out));
    release_height = drop.z.front();
    if (const auto top = bed_top_before(run->result.bed, drop.release_time)) {
      bed_top = *top;
      if (const auto passage = bed_passage(drop, bed_top)) entry = drop.time[passage->begin];
    }
  }
  const DataTable fall = clear_liquid_fall(release_height, bed_top);
  output.data.push_back(write_csv(fall, context.out));
  draw_figure_of_runs("fig08", panels(table, fall, end, entry), {520, 800}, context, keys);
  return output;
}

}  // namespace

Figure fig08() {
  return {"fig08", "History of the steel sphere at U_L = 0.10 m/s", needs, draw, "peng_2014/fig08_history"};
}

}  // namespace slfb
