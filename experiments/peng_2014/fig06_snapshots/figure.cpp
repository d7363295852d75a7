#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/figures/sphere_picture.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::fig06_snapshots {
namespace {

const FigureFolder folder{"peng_2014/fig06_snapshots"};

constexpr const char* system_name = "6in5W";
constexpr std::array velocities{0.07, 0.06, 0.05, 0.04, 0.03};  ///< in the order of the paper's panels [m/s]
constexpr double upper_height = 0.28;                           ///< of the panels [m]

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.system == system_name && spec.variant.empty() &&
           std::any_of(velocities.begin(), velocities.end(),
                       [&](double velocity) { return std::fabs(velocity - spec.superficial_velocity) < 1e-6; });
  });
}

/// What the paper says of the same panel.
std::string printed_end(double velocity) {
  const Peng2014& printed = peng_2014();
  if (velocity > 0.065) return fmt::format("bottom, {} s", printed.value("settling_time_0.07"));
  if (velocity > 0.055) return fmt::format("bottom, {} s", printed.value("settling_time_0.06"));
  return velocity > 0.045 ? fmt::format("falls, {:g} s", printed.value("followed_time")) : "rests on top";
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig06", {}, folder.caption(), run_notes(context, keys)};
  constexpr double panel_width = 0.155;  // over that of the picture
  constexpr int width = 560;
  // One scale for width and height: 0.05 m across. Above and below the panels stand 34 and 56 pixels of text.
  const int panel_height = static_cast<int>(panel_width * width * upper_height / 0.05);
  std::vector<std::string> tags, tables, simulated, printed, missing;
  for (const double velocity : velocities) {
    const std::string tag = fmt::format("{:.2f}", velocity);
    const FinishedRun* run = find_run(context, fmt::format("{}/{}", system_name, tag));
    const Snapshot* last = nullptr;
    if (run != nullptr)
      for (const Snapshot& snapshot : run->result.snapshots)
        if (snapshot.moment == "ends") last = &snapshot;
    tags.push_back(tag);
    printed.push_back(printed_end(velocity));
    missing.push_back(last != nullptr ? "" : run == nullptr ? "not yet simulated" : "positions not recorded");
    if (last == nullptr) {
      tables.emplace_back();
      simulated.emplace_back("–");
      continue;
    }
    const DataTable picture = sphere_picture(
        *last, {.lower_x = -0.025, .upper_x = 0.025, .lower_z = 0.0, .upper_z = upper_height}, "fig06_spheres_" + tag);
    output.data.push_back(write_csv(picture, context.out));
    tables.push_back(picture.name);
    const DropSeries& drop = run->result.drops.front();
    const double end = drop.bottom_time >= 0.0 ? drop.bottom_time : drop.time.back();
    simulated.push_back(fmt::format("{}{:.2f} s", drop.bottom_time >= 0.0 ? "bottom, " : "", end));
  }
  PlotValues values;
  values.number("upper_height", upper_height);
  values.number("panel_width", panel_width);
  values.texts("velocity", tags);
  values.files("spheres_table", tables);
  values.texts("simulated", simulated);
  values.texts("printed", printed);
  values.texts("missing", missing);
  draw_plot_of_runs("fig06", folder.plot(), values, {width, 34 + panel_height + 56}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig06", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig06_snapshots
