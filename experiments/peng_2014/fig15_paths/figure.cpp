#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "experiments/figures/figure_support.hpp"
#include "experiments/figures/sphere_picture.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in3W";
constexpr std::array voidages{0.45, 0.65, 0.79};  ///< of the paper's panels [-]
constexpr double panel_height = 0.13;             ///< shown about the sphere [m]
constexpr double nearest_enough = 0.05;           ///< in voidage, for a run to stand for a panel of the paper [-]

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile,
                         [](const RunSpec& spec) { return spec.system == system_name && spec.variant.empty(); });
}

/// The run whose bed has the voidage nearest to `voidage`, and that voidage.
std::optional<std::pair<const FinishedRun*, double>> nearest_run(const FigureContext& context, double voidage) {
  std::optional<std::pair<const FinishedRun*, double>> nearest;
  for (const auto& point : measured_points(context.measurements, "voidage_centre_of_mass", system_name)) {
    if (std::fabs(point.value - voidage) > nearest_enough) continue;
    if (nearest && std::fabs(nearest->second - voidage) <= std::fabs(point.value - voidage)) continue;
    const FinishedRun* run = find_run(context, run_key(system_name, point.superficial_velocity));
    if (run != nullptr && !run->result.snapshots.empty() && !run->result.drops.empty()) nearest = {run, point.value};
  }
  return nearest;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig15", {}, "", run_notes(context, keys)};
  output.caption =
      "The 6 mm steel sphere (red) halfway down through the bed of 3 mm glass in water, at the simulated voidages "
      "nearest "
      "to the paper's; rendered from the positions of the spheres, those in front of the plane y = 0 left out, those "
      "farther behind it paler. Red line: the path of its centre so far, seen from the same side. The caption of the "
      "paper's "
      "figure gives 0.65 for its third panel, its text 0.79.";
  const double width_of_panel = 0.205, pitch = 0.29, left = 0.15;
  const int width = 560;
  const int height_of_panel = static_cast<int>(width_of_panel * width * panel_height / 0.05);
  std::string script = fmt::format(
      "set multiplot\nunset grid\nunset key\nset border 15 linecolor rgb '#9aa3ad'\nunset xtics\nset ytics 0.05\n"
      "set xrange [-0.025:0.025]\nset tmargin at screen 1 - 34.0/height\nset bmargin at screen 1 - {}.0/height\n"
      "set label 3 'α_L ours' at screen 0.012, screen base + 38.0/height font ',12' textcolor rgb ours\n"
      "set label 4 'α_L paper' at screen 0.012, screen base + 16.0/height font ',12'\n",
      34 + height_of_panel);
  for (std::size_t place = 0; place < voidages.size(); ++place) {
    const auto nearest = nearest_run(context, voidages[place]);
    const Snapshot* halfway = nullptr;
    if (nearest)
      for (const Snapshot& snapshot : nearest->first->result.snapshots)
        if (snapshot.moment == "halfway") halfway = &snapshot;
    const double edge = left + pitch * static_cast<double>(place);
    double lower = 0.1;
    std::string plot = "NaN", title = "not yet simulated", ours = "–";
    if (halfway != nullptr) {
      const auto foreign = static_cast<std::size_t>(halfway->foreign);
      lower = std::max(0.0, std::floor((halfway->z[foreign] - 0.45 * panel_height) / 0.01) * 0.01);
      const std::string tag = fmt::format("{:.2f}", voidages[place]);
      const DataTable picture = sphere_picture(
          *halfway, {.lower_x = -0.025, .upper_x = 0.025, .lower_z = lower, .upper_z = lower + panel_height},
          "fig15_spheres_" + tag);
      DataTable path{"fig15_path_" + tag, {"x [m]", "y [m]", "z [m]"}, {}};
      const DropSeries& drop = nearest->first->result.drops.front();
      for (std::size_t i = 0; i < drop.time.size() && drop.z[i] > halfway->z[foreign]; ++i)
        if (drop.z[i] < lower + panel_height) path.rows.push_back({drop.x[i], drop.y[i], drop.z[i]});
      output.data.push_back(write_csv(picture, context.out));
      plot = plot_sphere_picture(picture.name, width_of_panel * width / 0.05);
      if (path.rows.size() > 1) {
        output.data.push_back(write_csv(path, context.out));
        plot += fmt::format(
            ", '{0}.csv' skip 1 using 1:3 with lines linecolor rgb '#ffffff' linewidth 3.4, '{0}.csv' skip 1 "
            "using 1:3 with lines linecolor rgb '#c0271c' linewidth 1.8",
            path.name);
      }
      title = fmt::format("U_L = {:.2f} m/s", nearest->first->spec.superficial_velocity);
      ours = fmt::format("{:.2f}", nearest->second);
    }
    script += fmt::format(
        "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset yrange [{:g}:{:g}]\n"
        "set title '{}' font ',13' offset 0,-0.6 {}\n"
        "set label 1 '{}' at graph 0.5, screen base + 38.0/height center font ',12' textcolor rgb ours\n"
        "set label 2 '{:.2f}' at graph 0.5, screen base + 16.0/height center font ',12'\n{}\nplot {}\n",
        edge, edge + width_of_panel, lower, lower + panel_height, title,
        halfway == nullptr ? "textcolor rgb quiet" : "textcolor rgb '#14181d'", ours, voidages[place],
        place == 0 ? "set ylabel 'height z [m]' offset 1.6,0" : "unset ylabel", plot);
    if (place == 0) script += "eval footer_drawn\nunset label 3\nunset label 4\n";
  }
  draw_figure_of_runs("fig15", script + "unset multiplot\n", {width, 34 + height_of_panel + 56}, context, keys);
  return output;
}

}  // namespace

Figure fig15() {
  return {"fig15", "The foreign particle on its way through the bed", needs, draw, "peng_2014/fig15_paths"};
}

}  // namespace slfb
