#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/figures/sphere_picture.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig15_paths {
namespace {

const FigureFolder folder{"peng_2014/fig15_paths"};
constexpr const char* system_name = "6in3W";
constexpr std::array voidages{0.45, 0.65, 0.79};  ///< of the paper's panels [-]
constexpr double panel_height = 0.13;             ///< shown about the sphere [m]
constexpr double scale = 2296.0;                  ///< of the panels [pixel/m]
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
  FigureOutput output{"fig15", {}, folder.caption(), run_notes(context, keys)};
  std::vector<double> bottoms;
  std::vector<std::string> headings, run_voidages, pictures, paths;
  for (const double voidage : voidages) {
    const auto nearest = nearest_run(context, voidage);
    const Snapshot* halfway = nullptr;
    if (nearest)
      for (const Snapshot& snapshot : nearest->first->result.snapshots)
        if (snapshot.moment == "halfway") halfway = &snapshot;
    if (halfway == nullptr) {
      bottoms.push_back(0.1);
      headings.emplace_back("not yet simulated");
      run_voidages.emplace_back("–");
      pictures.emplace_back();
      paths.emplace_back();
      continue;
    }
    const auto foreign = static_cast<std::size_t>(halfway->foreign);
    const double lower = std::max(0.0, std::floor((halfway->z[foreign] - 0.45 * panel_height) / 0.01) * 0.01);
    const double upper = lower + panel_height;
    const std::string tag = fmt::format("{:.2f}", voidage);
    const DataTable picture = sphere_picture(
        *halfway, {.lower_x = -0.025, .upper_x = 0.025, .lower_z = lower, .upper_z = upper}, "fig15_spheres_" + tag);
    DataTable path{"fig15_path_" + tag, {"x [m]", "y [m]", "z [m]"}, {}};
    const DropSeries& drop = nearest->first->result.drops.front();
    for (std::size_t i = 0; i < drop.time.size() && drop.z[i] > halfway->z[foreign]; ++i)
      if (drop.z[i] < upper) path.rows.push_back({drop.x[i], drop.y[i], drop.z[i]});
    output.data.push_back(write_csv(picture, context.out));
    const bool is_line = path.rows.size() > 1;
    if (is_line) output.data.push_back(write_csv(path, context.out));
    bottoms.push_back(lower);
    headings.push_back(fmt::format("U_L = {:.2f} m/s", nearest->first->spec.superficial_velocity));
    run_voidages.push_back(fmt::format("{:.2f}", nearest->second));
    pictures.push_back(picture.name);
    paths.push_back(is_line ? path.name : "");
  }
  PlotValues values;
  values.number("scale", scale);
  values.number("panel_height", panel_height);
  values.numbers("voidage", {voidages.begin(), voidages.end()});
  values.texts("run_voidage", run_voidages);
  values.markups("heading", headings);
  values.numbers("bottom", bottoms);
  values.files("picture", pictures);
  values.files("path", paths);
  draw_plot_of_runs("fig15", folder.plot(), values, {560, 34 + static_cast<int>(scale * panel_height) + 56}, context,
                    keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig15", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig15_paths
