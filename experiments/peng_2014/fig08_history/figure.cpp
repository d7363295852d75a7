#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/run/one_particle.hpp"

namespace slfb::fig08_history {
namespace {

const FigureFolder folder{"peng_2014/fig08_history"};

constexpr double superficial_velocity = 0.10;  // the one that the paper shows [m/s]

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.system == "6in5W" && spec.variant.empty() &&
           std::fabs(spec.superficial_velocity - superficial_velocity) < 1e-6;
  });
}

/// One of the six panels; panel k shows column k + 1 of the history, both counted from zero.
struct Panel {
  std::size_t fall_column;  ///< of the sphere alone in clear liquid; 0, which is time: not drawn
  double lower, upper;      ///< of the axis while nothing is simulated
};

/// Height, vertical velocity, angular speed, voidage, liquid velocity, Reynolds number.
constexpr std::array<Panel, 6> panels{
    {{1, 0.0, 1.0}, {2, -1.0, 0.0}, {0, 0.0, 40.0}, {0, 0.4, 1.0}, {0, 0.0, 0.4}, {3, 0.0, 8000.0}}};

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

/// Smallest and largest value of one column.
std::pair<double, double> range(const DataTable& table, std::size_t column) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const auto& row : table.rows) {
    lower = std::min(lower, row[column]);
    upper = std::max(upper, row[column]);
  }
  return {lower, upper};
}

/// The axes of the six panels: from one mark to another, around all that is drawn.
void add_axes(const DataTable& history, const DataTable& fall, PlotValues& values) {
  std::vector<double> lowers, uppers, steps, fall_columns;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const Panel& panel = panels[k];
    auto [lower, upper] = std::pair{panel.lower, panel.upper};
    if (!history.rows.empty()) {
      std::tie(lower, upper) = range(history, k + 1);
      if (panel.fall_column > 0) {
        const auto [lower_fall, upper_fall] = range(fall, panel.fall_column);
        lower = std::min(lower, lower_fall);
        upper = std::max(upper, upper_fall);
      }
    }
    const double step = tic_step(std::max(upper - lower, 1e-6));
    lowers.push_back(step * std::floor(lower / step));
    uppers.push_back(step * std::ceil(upper / step));
    steps.push_back(step);
    fall_columns.push_back(panel.fall_column > 0 ? static_cast<double>(panel.fall_column + 1) : 0.0);
  }
  values.numbers("lower", lowers);
  values.numbers("upper", uppers);
  values.numbers("step", steps);
  values.numbers("fall_column", fall_columns);
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const std::string key = run_key("6in5W", superficial_velocity);
  const FinishedRun* run = find_run(context, key);
  if (run != nullptr && run->result.drops.empty()) run = nullptr;
  FigureOutput output{"fig08", {}, folder.caption(), run_notes(context, keys)};
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
  PlotValues values;
  values.number("simulated", table.rows.empty() ? 0.0 : 1.0);
  values.number("end", end);
  values.number("time_step", tic_step(end));
  values.number("entry", entry);
  add_axes(table, fall, values);
  draw_plot_of_runs("fig08", folder.plot(), values, {520, 800}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig08", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig08_history
