#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

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
  FigureOutput output{"fig14", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Liquid in the plane y = 0 at the end of the fluidisation stage, bed of 5 mm glass. Left: vorticity about y "
      "(∂u_x/∂z − ∂u_z/∂x) by central differences on the cells of the fluid grid, on the colour scale of the paper, "
      "{:g} "
      "to {:g} 1/s; grey: no difference across the edge. Right: speed of the interstitial liquid and its direction "
      "between "
      "{} and {} m, at the lowest and the highest velocity of the series. The paper's pictures are not available as "
      "numbers.",
      peng_2014().value("vorticity_lowest"), peng_2014().value("vorticity_highest"), window_bottom, window_top);
  const int width = 760;
  const double panel_width = 0.083, window_width = 0.155;
  // One scale for width and height: 0.05 m across, 0.4 m up on the left and 0.1 m on the right.
  const Canvas canvas{width, static_cast<int>(8.0 * panel_width * width) + 36 + 84};
  std::string script = fmt::format(
      "set multiplot\nunset grid\nunset key\nset border 15\nunset xtics\nset style fill solid noborder\n"
      "set xrange [-0.025:0.025]\nset yrange [0:0.4]\nset ytics 0, 0.1\nset tmargin at screen 1 - 36.0/height\n"
      "set bmargin at screen base + 84.0/height\nset cbrange [{:g}:{:g}]\n"
      "set palette defined (-80 '#2166ac', -40 '#92c5de', 0 '#f7f7f7', 45 '#f4a582', 90 '#b2182b')\n"
      "set colorbox horizontal user origin 0.095, base + 40.0/height size {:.4f}, 10.0/height\n"
      "set cbtics 40 out scale 0.5 offset 0,0.4 font ',12'\n"
      "set label 6 'U_L [m/s]' at screen 0.012, screen 1 - 18.0/height font ',12'\n"
      "set label 7 'vorticity [1/s]' at screen {:.4f}, screen base + 60.0/height center font ',12'\n",
      peng_2014().value("vorticity_lowest"), peng_2014().value("vorticity_highest"), 5 * 0.091 + panel_width,
      0.095 + 0.5 * (5 * 0.091 + panel_width));
  std::size_t place = 0;
  for (const auto& point : printed) {
    const std::string tag = fmt::format("{:.2f}", point.superficial_velocity);
    const FinishedRun* run = find_run(context, fmt::format("{}/{}", system_name, tag));
    if (run != nullptr && plane_vorticity(run->result.plane).empty()) run = nullptr;
    const double left = 0.095 + 0.091 * static_cast<double>(place);
    script += fmt::format(
        "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset title '{}' font ',12' offset 0,-0.6\n{}\n",
        left, left + panel_width, tag,
        place == 0 ? "set ylabel 'height z [m]' offset 1.6,0" : "set format y ''\nunset ylabel");
    if (run != nullptr) {
      const DataTable table = cells(run->result.plane, "fig14_plane_" + tag);
      output.data.push_back(write_csv(table, context.out));
      const PlaneField& plane = run->result.plane;
      script += fmt::format(
          "half_x = {0:.6g}\nhalf_z = {1:.6g}\nset object 1 rectangle from graph 0, 0 to graph 1, 1 behind fillcolor "
          "rgb "
          "'#dfe3e8' fillstyle solid noborder\n"
          "plot '{2}.csv' skip 1 using ($3==$3 ? $1 : NaN):2:(half_x):(half_z):3 with boxxyerror linecolor palette\n"
          "unset object 1\n",
          0.52 * (plane.x[1] - plane.x[0]), 0.52 * (plane.z[1] - plane.z[0]), table.name);
    } else {
      script +=
          "set label 8 'not yet simulated' at graph 0.5, 0.5 center rotate by 90 font ',12' textcolor rgb quiet\n"
          "plot NaN\nunset label 8\n";
    }
    if (place == 0) script += "eval footer_drawn\nunset label 6\nunset label 7\n";
    script += "unset colorbox\n";
    ++place;
  }

  script += fmt::format(
      "set palette defined (0 '#440154', 1 '#3e4989', 2 '#26828e', 3 '#35b779', 4 '#b5de2b', 5 '#fde725')\nset cbrange "
      "[0:{:g}]\nset yrange [{:g}:{:g}]\nset ytics 0.05\nset format y "
      "'%g'\nset colorbox horizontal user origin {:.4f}, base + 40.0/height size {:.4f}, 10.0/height\nset cbtics 0.1\n"
      "set label 7 'speed of the liquid [m/s]' at screen {:.4f}, screen base + 60.0/height center font ',12'\n",
      peng_2014().value("speed_axis"), window_bottom, window_top, 0.695, 0.96 - 0.695, 0.5 * (0.96 + 0.695));
  for (const auto& [tag, top] : {std::pair{"0.06", 0.0}, std::pair{"0.11", 1.0}}) {
    const FinishedRun* run = find_run(context, fmt::format("{}/{}", system_name, tag));
    if (run != nullptr && plane_vorticity(run->result.plane).empty()) run = nullptr;
    script += fmt::format(
        "set lmargin at screen 0.75\nset rmargin at screen {0:.4f}\n"
        "set tmargin at screen 1 - (36.0 + {1:g}*({2:.1f} + 30.0))/height\n"
        "set bmargin at screen 1 - (36.0 + {1:g}*({2:.1f} + 30.0) + {2:.1f})/height\nset title '{3} m/s' font ',12'\n",
        0.75 + window_width, top, 2.0 * window_width * width, tag);
    if (run == nullptr) {
      script +=
          "set label 8 'not yet simulated' at graph 0.5, 0.5 center font ',12' textcolor rgb quiet\n"
          "plot NaN\nunset label 8\n";
    } else {
      // A vector of 0.25 m/s is as long as a cell; black on yellow and white on violet would vanish, so both are drawn.
      const std::string vectors = fmt::format(
          "using ($1 - 0.5*scale*$5):($2 - 0.5*scale*$6):(scale*$5):(scale*$6) with vectors head filled size "
          "0.0012,20 ");
      script += fmt::format(
          "scale = {0:.6g}\nplot 'fig14_plane_{1}.csv' skip 1 using 1:2:(half_x):(half_z):4 with boxxyerror linecolor "
          "palette, '' skip 1 {2} linecolor rgb '#ffffff' linewidth 2.6, '' skip 1 {2} linecolor rgb '#14181d' "
          "linewidth "
          "1.1\n",
          (run->result.plane.x[1] - run->result.plane.x[0]) / 0.25, tag, vectors);
    }
    script += "unset label 7\nunset colorbox\n";
  }
  draw_figure_of_runs("fig14", script + "unset multiplot\n", canvas, context, keys);
  return output;
}

}  // namespace

Figure fig14() {
  return {"fig14", "Vorticity and velocity of the liquid in the plane y = 0", needs, draw, "peng_2014/fig14_vorticity"};
}

}  // namespace slfb
