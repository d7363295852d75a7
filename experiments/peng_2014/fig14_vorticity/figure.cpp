#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/quantities/analysis.hpp"

namespace slfb::fig14_vorticity {
namespace {

const FigureFolder folder{"peng_2014/fig14_vorticity"};

constexpr const char* system_name = "6in5W";
/// The window of the two panels with speed and vectors, twice as tall as wide [m].
constexpr double window_bottom = 0.1, window_top = 0.2;

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    const auto& printed = peng_2014().figure13();
    return spec.system == system_name && spec.variant.empty() &&
           std::any_of(printed.begin(), printed.end(), [&](const VoidagePoint& point) {
             return std::fabs(point.superficial_velocity - spec.superficial_velocity) < 1e-6;
           });
  });
}

/// Cells up to a little above the part that the paper shows.
DataTable cells(const PlaneField& plane, const std::string& name) {
  DataTable table{
      name, {"x [m]", "z [m]", "vorticity about y [1/s]", "speed [m/s]", "velocity x [m/s]", "velocity z [m/s]"}, {}};
  const auto vorticity = plane_vorticity(plane);
  for (std::size_t iz = 0; iz < plane.z.size() && plane.z[iz] < 0.42; ++iz)
    for (std::size_t ix = 0; ix < plane.x.size(); ++ix) {
      const std::size_t here = iz * plane.x.size() + ix;
      table.rows.push_back({plane.x[ix], plane.z[iz], vorticity[here],
                            std::hypot(plane.velocity_x[here], plane.velocity_z[here]), plane.velocity_x[here],
                            plane.velocity_z[here]});
    }
  return table;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const auto& printed = peng_2014().figure13();
  const double lowest = peng_2014().value("vorticity_lowest"), highest = peng_2014().value("vorticity_highest");
  FigureOutput output{"fig14",
                      {},
                      folder.caption({{"lowest", fmt::format("{:g}", lowest)},
                                      {"highest", fmt::format("{:g}", highest)},
                                      {"bottom", fmt::format("{}", window_bottom)},
                                      {"top", fmt::format("{}", window_top)}}),
                      run_notes(context, keys)};
  std::vector<std::string> tags, tables;
  std::vector<double> cells_x, cells_z;
  for (const auto& point : printed) {
    const std::string tag = fmt::format("{:.2f}", point.superficial_velocity);
    const FinishedRun* run = find_run(context, fmt::format("{}/{}", system_name, tag));
    if (run != nullptr && plane_vorticity(run->result.plane).empty()) run = nullptr;
    tags.push_back(tag);
    tables.emplace_back();
    cells_x.push_back(run == nullptr ? std::nan("") : run->result.plane.x[1] - run->result.plane.x[0]);
    cells_z.push_back(run == nullptr ? std::nan("") : run->result.plane.z[1] - run->result.plane.z[0]);
    if (run == nullptr) continue;
    const DataTable table = cells(run->result.plane, "fig14_plane_" + tag);
    output.data.push_back(write_csv(table, context.out));
    tables.back() = table.name;
  }

  constexpr int width = 760;
  constexpr double panel_width = 0.083, window_width = 0.155;  // over that of the picture
  PlotValues values;
  values.number("panel_width", panel_width);
  values.number("window_width", window_width);
  values.number("vorticity_lowest", lowest);
  values.number("vorticity_highest", highest);
  values.number("speed_axis", peng_2014().value("speed_axis"));
  values.number("window_bottom", window_bottom);
  values.number("window_top", window_top);
  values.texts("velocity", tags);
  values.files("plane", tables);
  values.numbers("cell_x", cells_x);
  values.numbers("cell_z", cells_z);
  // One scale for width and height: 0.05 m across, 0.4 m up on the left and 0.1 m on the right. Above and below the
  // panels stand 36 and 84 pixels of text.
  const Canvas canvas{width, static_cast<int>(8.0 * panel_width * width) + 36 + 84};
  draw_plot_of_runs("fig14", folder.plot(), values, canvas, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig14", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig14_vorticity
