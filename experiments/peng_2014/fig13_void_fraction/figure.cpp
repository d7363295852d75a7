#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

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

/// Half the width of a cell, a little widened so that no seam of background shows between neighbours.
double half_cell(const std::vector<double>& centres) {
  return centres.size() < 2 ? 0.0 : 0.52 * (centres[1] - centres[0]);
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const auto& printed = peng_2014().figure13();
  FigureOutput output{"fig13", {}, "", run_notes(context, keys)};
  output.caption =
      "Voidage in the plane y = 0 at the end of the fluidisation stage, on the cells of the fluid grid. Below each "
      "panel: "
      "the mean voidage of our bed (from twice the height of its centre of mass, averaged over time) and the one "
      "printed "
      "in the paper; the panels are 50 mm wide. The paper shows the field after 20 s; its picture is not available as "
      "numbers.";

  DataTable means{"fig13_means",
                  {"superficial velocity [m/s]", "voidage of the paper [-]", "simulated voidage [-]",
                   "half width of its 95 % interval [-]"},
                  {}};
  const double panel_width = 0.112;
  // Width and height of a panel share one scale: 0.05 m across, 0.4 m up.
  const Canvas canvas{560, static_cast<int>(8.0 * panel_width * 560) + 34 + 62};
  std::string script =
      "set multiplot\nset xrange [-0.025:0.025]\nset yrange [0:0.4]\nset cbrange [0.4:1]\nunset grid\nunset key\nset "
      "border 15\n"
      "unset xtics\nset ytics 0, 0.1\nset tmargin at screen 1 - 34.0/height\nset bmargin at screen base + 62.0/height\n"
      "set colorbox user origin 0.89, base + 62.0/height size 0.022, 1 - base - 96.0/height\nset cbtics 0.4, 0.1 out "
      "scale 0.5\n";
  std::size_t place = 0;
  for (const auto& point : printed) {
    const std::string tag = fmt::format("{:.2f}", point.superficial_velocity);
    const std::string key = run_key("6in5W", point.superficial_velocity);
    const FinishedRun* run = find_run(context, key);
    if (run != nullptr && run->result.plane.voidage.empty()) run = nullptr;
    const auto measured =
        context.measurements.find(measure_key("voidage_centre_of_mass", "6in5W", point.superficial_velocity));
    std::string ours = "–";
    if (measured != context.measurements.end()) {
      ours = fmt::format("{:.3f}", measured->second.value);
      means.rows.push_back(
          {point.superficial_velocity, point.voidage, measured->second.value, measured->second.half_width});
    } else {
      means.rows.push_back({point.superficial_velocity, point.voidage, std::nan(""), std::nan("")});
    }
    const double left = 0.135 + 0.124 * static_cast<double>(place);
    script += fmt::format(
        "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset title '{}' font ',13' offset 0,-0.6\n"
        "set label 1 '{}' at graph 0.5, screen base + 40.0/height center font ',12' textcolor rgb ours\n"
        "set label 2 '{:.2f}' at graph 0.5, screen base + 18.0/height center font ',12' textcolor rgb paper\n",
        left, left + panel_width, tag, ours, point.voidage);
    if (place == 0)
      script +=
          "set ylabel 'height z [m]' offset 1,0\nset label 3 'ours' at screen 0.015, screen base + 40.0/height font "
          "',12' "
          "textcolor rgb ours\nset label 4 'paper' at screen 0.015, screen base + 18.0/height font ',12'\n"
          "set label 5 'U_L [m/s]' at screen 0.015, screen 1 - 16.0/height font ',12'\n"
          "set label 7 'α_L [-]' at screen 0.985, screen 1 - 16.0/height right font ',12'\n";
    if (run != nullptr) {
      const DataTable table = cells(run->result.plane, "fig13_plane_" + tag);
      output.data.push_back(write_csv(table, context.out));
      script += fmt::format(
          "plot '{}.csv' skip 1 using 1:2:({:.6g}):({:.6g}):3 with boxxyerror fillstyle solid noborder linecolor "
          "palette\n",
          table.name, half_cell(run->result.plane.x), half_cell(run->result.plane.z));
    } else {
      script +=
          "set label 6 'not yet simulated' at graph 0.5, 0.5 center rotate by 90 textcolor rgb quiet\nplot NaN\n"
          "unset label 6\n";
    }
    if (place == 0)
      script +=
          "eval footer_drawn\nunset ylabel\nunset label 3\nunset label 4\nunset label 5\nunset label 7\nset format y "
          "''\n";
    if (run != nullptr) script += "unset colorbox\n";
    ++place;
  }
  output.data.push_back(write_csv(means, context.out));
  draw_figure_of_runs("fig13", script + "unset multiplot\n", canvas, context, keys);
  return output;
}

}  // namespace

Figure fig13() { return {"fig13", "Void fraction in the plane y = 0", needs, draw, "peng_2014/fig13_void_fraction"}; }

}  // namespace slfb
