#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig13_void_fraction {
namespace {

const FigureFolder folder{"peng_2014/fig13_void_fraction"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    const auto& printed = peng_2014().figure13();
    return spec.system == "6in5W" && spec.variant.empty() &&
           std::any_of(printed.begin(), printed.end(), [&](const VoidagePoint& point) {
             return std::fabs(point.superficial_velocity - spec.superficial_velocity) < 1e-6;
           });
  });
}

/// Cells up to a little above the part that the paper shows.
DataTable cells(const PlaneField& plane, const std::string& name) {
  DataTable table{name, {"x [m]", "z [m]", "voidage [-]"}, {}};
  for (std::size_t iz = 0; iz < plane.z.size() && plane.z[iz] < 0.42; ++iz)
    for (std::size_t ix = 0; ix < plane.x.size(); ++ix)
      table.rows.push_back({plane.x[ix], plane.z[iz], plane.voidage[iz * plane.x.size() + ix]});
  return table;
}

/// Distance of neighbouring cells [m].
double cell_size(const std::vector<double>& centres) { return centres.size() < 2 ? 0.0 : centres[1] - centres[0]; }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const auto& printed = peng_2014().figure13();
  FigureOutput output{"fig13", {}, folder.caption(), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::voidage}, context, output);

  DataTable means{"fig13_means",
                  {"superficial velocity [m/s]", "voidage of the paper [-]", "simulated voidage [-]",
                   "half width of its 95 % interval [-]"},
                  {}};
  std::vector<std::string> tags, tables, simulated, paper;
  std::vector<double> cells_x, cells_z;
  for (const auto& point : printed) {
    const std::string tag = fmt::format("{:.2f}", point.superficial_velocity);
    const std::string key = run_key("6in5W", point.superficial_velocity);
    const FinishedRun* run = find_run(context, key);
    if (run != nullptr && run->result.plane.voidage.empty()) run = nullptr;
    const auto found =
        context.measurements.find(measure_key("voidage_centre_of_mass", "6in5W", point.superficial_velocity));
    const Measurement measured = found == context.measurements.end() ? Measurement{} : found->second;
    means.rows.push_back({point.superficial_velocity, point.voidage, measured.value, measured.half_width});
    tags.push_back(tag);
    tables.emplace_back();
    simulated.push_back(std::isnan(measured.value) ? "–" : fmt::format("{:.3f}", measured.value));
    paper.push_back(fmt::format("{:.2f}", point.voidage));
    cells_x.push_back(run == nullptr ? std::nan("") : cell_size(run->result.plane.x));
    cells_z.push_back(run == nullptr ? std::nan("") : cell_size(run->result.plane.z));
    if (run == nullptr) continue;
    const DataTable table = cells(run->result.plane, "fig13_plane_" + tag);
    output.data.push_back(write_csv(table, context.out));
    tables.back() = table.name;
  }
  output.data.push_back(write_csv(means, context.out));

  constexpr int width = 560;
  constexpr double panel_width = 0.112;  // over that of the picture
  PlotValues values;
  values.number("panel_width", panel_width);
  values.texts("velocity", tags);
  values.files("plane", tables);
  values.numbers("cell_x", cells_x);
  values.numbers("cell_z", cells_z);
  values.texts("simulated", simulated);
  values.texts("printed", paper);
  // One scale for width and height: 0.05 m across, 0.4 m up. Above and below the panels stand 34 and 62 pixels of text.
  const Canvas canvas{width, static_cast<int>(8.0 * panel_width * width) + 34 + 62};
  draw_plot_of_runs("fig13", folder.plot(), values, canvas, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig13", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig13_void_fraction
