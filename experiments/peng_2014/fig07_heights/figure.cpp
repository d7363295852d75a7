#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";
constexpr std::array velocities{0.03, 0.04, 0.05, 0.06, 0.07};  ///< around minimum fluidisation [m/s]
constexpr std::array colours{"#440154", "#3b528b", "#21918c", "#5ec962", "#d55e00"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.system == system_name && spec.variant.empty() &&
           std::any_of(velocities.begin(), velocities.end(),
                       [&](double velocity) { return std::fabs(velocity - spec.superficial_velocity) < 1e-6; });
  });
}

/// Heights of all drops at one velocity; told apart by their number.
DataTable heights(const FigureContext& context, const std::string& key, const std::string& name) {
  DataTable table{name, {"drop [-]", "time since release [s]", "height of the centre [m]"}, {}};
  double number = 0.0;
  const FinishedRun* run = find_run(context, key);
  if (run == nullptr) return table;
  for (const auto& drop : run->result.drops) {
    ++number;
    double last = -1.0;
    for (std::size_t i = 0; i < drop.time.size(); ++i) {
      if (drop.time[i] - last < 0.0199 && i + 1 < drop.time.size()) continue;
      last = drop.time[i];
      table.rows.push_back({number, drop.time[i], drop.z[i]});
    }
  }
  return table;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig07", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Height of the 6 mm steel sphere above the distributor after its release, around minimum fluidisation: each of "
      "our "
      "drops. Black: what the paper prints. At 0.03 and 0.04 m/s its sphere rests on the bed ({} m, dashed); at 0.05 "
      "m/s it "
      "still falls after {:g} s; at 0.06 and 0.07 m/s it reaches the bottom after {} and {} s (open circles). The "
      "paper's "
      "curves are not available as numbers, nor is the height at 0.05 m/s.",
      printed.value("packed_height"), printed.value("followed_time"), printed.value("settling_time_0.06"),
      printed.value("settling_time_0.07"));
  output.data.push_back(write_csv(
      {"fig07_paper",
       {"superficial velocity [m/s]", "time of arrival [s]", "height of the centre [m]"},
       {{0.06, printed.value("settling_time_0.06"), 0.003}, {0.07, printed.value("settling_time_0.07"), 0.003}}},
      context.out));
  std::string simulated;
  for (std::size_t place = 0; place < velocities.size(); ++place) {
    const std::string tag = fmt::format("{:.2f}", velocities[place]);
    const DataTable table = heights(context, fmt::format("{}/{}", system_name, tag), "fig07_drops_" + tag);
    if (table.rows.empty()) {
      simulated += fmt::format(", NaN with lines linecolor rgb '{}' linewidth 2 title '{} m/s, not yet simulated'",
                               colours[place], tag);
      continue;
    }
    output.data.push_back(write_csv(table, context.out));
    const int drops = static_cast<int>(table.rows.back()[0]);
    for (int drop = 1; drop <= drops; ++drop)
      simulated +=
          fmt::format(", '{}.csv' skip 1 using ($1=={} ? $2 : NaN):3 with lines linecolor rgb '{}' linewidth {} {}",
                      table.name, drop, colours[place], drop == 1 ? 2.0 : 1.2,
                      drop == 1 ? fmt::format("title '{} m/s'", tag) : std::string("notitle"));
  }
  const std::string script = fmt::format(
      "set key top right Left reverse font ',12' title 'U_L' left\nset xrange [0:{0:g}]\nset yrange [0:1]\n"
      "set xlabel 'time since release [s]'\nset ylabel 'height z of the sphere [m]'\n"
      "set label 1 'paper: rests here at 0.03, 0.04' at graph 0.98, first {1:g} right offset 0,-0.7 font ',11'\n"
      "set label 2 'paper: arrives' at first {2:g}, first 0.003 offset 0.6,0.9 font ',11'\n"
      "plot {1:g} with lines linestyle 1 notitle{3}, "
      "'fig07_paper.csv' skip 1 using 2:3 with points linestyle 1 dashtype 1 notitle\n",
      printed.value("followed_time"), printed.value("packed_height"), printed.value("settling_time_0.06"), simulated);
  draw_figure_of_runs("fig07", script, {560, 430}, context, keys);
  return output;
}

}  // namespace

Figure fig07() {
  return {"fig07", "Height of the foreign particle around minimum fluidisation", needs, draw,
          "peng_2014/fig07_heights"};
}

}  // namespace slfb
