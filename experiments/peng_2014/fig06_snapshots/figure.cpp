#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_support.hpp"
#include "experiments/figures/sphere_picture.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

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
  FigureOutput output{"fig06", {}, "", run_notes(context, keys)};
  output.caption =
      "The bed of 5 mm glass with the 6 mm steel sphere (red) at the end of its fall, or of the time it was followed, "
      "around minimum fluidisation: our first drop, rendered from the positions of the spheres. Spheres in front of "
      "the "
      "plane y = 0 are left out, those farther behind it are paler. Below: the time since the release, and what the "
      "paper "
      "says of the same panel.";
  const double panel_width = 0.155, pitch = 0.17, left = 0.13;
  const int width = 560;
  const int panel_height = static_cast<int>(panel_width * width * upper_height / 0.05);
  std::string script = fmt::format(
      "set multiplot\nunset grid\nunset key\nset border 15 linecolor rgb '#9aa3ad'\nunset xtics\nset ytics 0, 0.1\n"
      "set xrange [-0.025:0.025]\nset yrange [0:{}]\nset tmargin at screen 1 - 34.0/height\n"
      "set bmargin at screen 1 - {}.0/height\n"
      "set label 5 'U_L [m/s]' at screen 0.012, screen 1 - 17.0/height font ',12'\n"
      "set label 3 'ours' at screen 0.012, screen base + 38.0/height font ',12' textcolor rgb ours\n"
      "set label 4 'paper' at screen 0.012, screen base + 16.0/height font ',12'\n",
      upper_height, 34 + panel_height);
  for (std::size_t place = 0; place < velocities.size(); ++place) {
    const std::string tag = fmt::format("{:.2f}", velocities[place]);
    const FinishedRun* run = find_run(context, fmt::format("{}/{}", system_name, tag));
    const Snapshot* last = nullptr;
    if (run != nullptr)
      for (const Snapshot& snapshot : run->result.snapshots)
        if (snapshot.moment == "ends") last = &snapshot;
    const double edge = left + pitch * static_cast<double>(place);
    std::string ours = "–", plot = "NaN";
    if (last != nullptr) {
      const DataTable picture =
          sphere_picture(*last, {.lower_x = -0.025, .upper_x = 0.025, .lower_z = 0.0, .upper_z = upper_height},
                         "fig06_spheres_" + tag);
      output.data.push_back(write_csv(picture, context.out));
      plot = plot_sphere_picture(picture.name, panel_width * width / 0.05);
      const DropSeries& drop = run->result.drops.front();
      const double end = drop.bottom_time >= 0.0 ? drop.bottom_time : drop.time.back();
      ours = fmt::format("{}{:.2f} s", drop.bottom_time >= 0.0 ? "bottom, " : "", end);
    }
    script += fmt::format(
        "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset title '{}' font ',13' offset 0,-0.6\n"
        "set label 1 '{}' at graph 0.5, screen base + 38.0/height center font ',11' textcolor rgb ours\n"
        "set label 2 '{}' at graph 0.5, screen base + 16.0/height center font ',11'\n"
        "set label 6 '{}' at graph 0.5, 0.5 center rotate by 90 font ',12' textcolor rgb quiet\n"
        "{}\nplot {}\n",
        edge, edge + panel_width, tag, ours, printed_end(velocities[place]),
        last != nullptr  ? ""
        : run == nullptr ? "not yet simulated"
                         : "positions not recorded",
        place == 0 ? "set ylabel 'height z [m]' offset 0.8,0" : "set format y ''\nunset ylabel", plot);
    if (place == 0) script += "eval footer_drawn\nunset label 3\nunset label 4\nunset label 5\n";
  }
  draw_figure_of_runs("fig06", script + "unset multiplot\n", {width, 34 + panel_height + 56}, context, keys);
  return output;
}

}  // namespace

Figure fig06() {
  return {"fig06", "The bed at the end of the fall around minimum fluidisation", needs, draw,
          "peng_2014/fig06_snapshots"};
}

}  // namespace slfb
