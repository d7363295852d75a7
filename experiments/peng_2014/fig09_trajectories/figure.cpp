#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

bool wanted(const RunSpec& spec) { return spec.system == "6in5W" && spec.variant.empty(); }

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return wanted(spec) && spec.superficial_velocity > 0.055;  // below, the paper fits no line
  });
}

/// Samples and fitted lines of all drops at one velocity, on a clock that reads zero where the line passes the top of
/// the window. Returns whether there is any.
bool tabulate(const FigureContext& context, double velocity, DataTable& samples, DataTable& fits) {
  int number = 0;
  const std::string key = run_key("6in5W", velocity);
  for (const auto& run : context.runs) {
    if (run_key(run.spec) != key) continue;
    for (const auto& drop : run.result.drops) {
      const auto fit = fit_classification(drop, 0.0);
      if (!fit || fit->velocity <= 0.0) continue;
      ++number;
      const double origin = (fit->intercept - classification_window_top) / fit->velocity;
      const double margin = 0.01;  // of height, shown above and below the window [m]
      double last_time = -1.0;
      for (std::size_t i = 0; i < drop.time.size(); ++i) {
        if (drop.z[i] < classification_window_bottom - margin) break;
        // 200 points a second are enough for the eye and keep the SVG small.
        if (drop.z[i] > classification_window_top + margin || drop.time[i] - last_time < 0.0049) continue;
        last_time = drop.time[i];
        samples.rows.push_back({static_cast<double>(number), drop.time[i] - origin, drop.z[i]});
      }
      fits.rows.push_back({static_cast<double>(number), fit->velocity, fit->r_squared, drop.release_time});
    }
  }
  return number > 0;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig09", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Height of the steel sphere between {:.1f} and {:.1f} m above the distributor, one panel per superficial "
      "velocity. "
      "Thin blue lines: each simulated drop, sampled, with its fitted straight line; dashed black: the line that the "
      "paper "
      "prints for its single drop. Every curve starts its clock where its own line passes {:.1f} m, so that slopes "
      "(classification velocities) can be compared whatever the height of release and the swelling of the bed; the "
      "arrival times themselves stand in Table 2. Each panel has its own axis of time.",
      classification_window_bottom, classification_window_top, classification_window_top);

  std::set<double> velocities;
  for (const auto& spec : context.profile.runs)
    if (wanted(spec) && spec.superficial_velocity > 0.055) velocities.insert(spec.superficial_velocity);
  if (velocities.empty())
    for (const auto& row : peng_2014().table2()) velocities.insert(row.superficial_velocity);

  DataTable paper{"fig09_paper", {"superficial velocity [m/s]", "classification velocity [m/s]", "R^2 [-]"}, {}};
  for (const auto& row : peng_2014().table2())
    paper.rows.push_back({row.superficial_velocity, row.classification_velocity, row.r_squared});
  output.data.push_back(write_csv(paper, context.out));

  const int columns = std::min<int>(3, static_cast<int>(velocities.size()));
  const int rows = (static_cast<int>(velocities.size()) + columns - 1) / columns;
  std::string script = fmt::format(
      "set multiplot\ncolumns = {}\nrows = {}\nleft = 0.1\nright = 0.985\nbottom = base + 60.0/height\ntop = 1 - "
      "62.0/height\n"
      "gap_x = 0.03\ngap_y = 52.0/height\nwide = (right - left - (columns - 1)*gap_x)/columns\n"
      "high = (top - bottom - (rows - 1)*gap_y)/rows\nset yrange [0.09:0.21]\nset ytics 0.1, 0.05\nunset key\n",
      columns, rows);
  int place = 0;
  std::string panels;
  for (const double velocity : velocities) {
    const std::string tag = fmt::format("{:.2f}", velocity);
    DataTable samples{"fig09_drops_" + tag, {"drop [-]", "time since the line passes 0.2 m [s]", "height [m]"}, {}};
    DataTable fits{"fig09_fits_" + tag,
                   {"drop [-]", "classification velocity [m/s]", "R^2 [-]", "release on the clock of the bed [s]"},
                   {}};
    const bool simulated = tabulate(context, velocity, samples, fits);
    std::string plot;
    double longest = 0.0;  // time that a straight line takes through the window
    if (simulated) {
      output.data.push_back(write_csv(samples, context.out));
      output.data.push_back(write_csv(fits, context.out));
      for (const auto& row : fits.rows) longest = std::max(longest, 0.1 / row[1]);
      for (std::size_t drop = 1; drop <= fits.rows.size(); ++drop)
        plot += fmt::format(
            "'{}.csv' skip 1 using ($1=={} ? $2 : NaN):3 with lines linecolor rgb pale_2 linewidth 2.2, "
            "0.2 - {:.6g}*x with lines linecolor rgb '#003f63' linewidth 0.9, ",
            samples.name, drop, fits.rows[drop - 1][1]);
    }
    const auto& table2 = peng_2014().table2();
    const auto printed = std::find_if(table2.begin(), table2.end(), [&](const Table2Row& row) {
      return std::fabs(row.superficial_velocity - velocity) < 1e-6;
    });
    if (printed != table2.end()) {
      longest = std::max(longest, 0.1 / printed->classification_velocity);
      plot += fmt::format("0.2 - {:.6g}*x with lines linestyle 1", printed->classification_velocity);
    } else {
      plot += "NaN";
    }
    const int row = place / columns;
    const int column = place % columns;
    panels += fmt::format(
        "set lmargin at screen left + {0}*(wide + gap_x)\nset rmargin at screen left + {0}*(wide + gap_x) + wide\n"
        "set tmargin at screen top - {1}*(high + gap_y)\nset bmargin at screen top - {1}*(high + gap_y) - high\n"
        "set title 'U_L = {2} m/s' font ',13' offset 0,-0.7\n"
        "set label 1 '{3}' at graph 0.97, 0.92 right font ',11' textcolor rgb quiet\n",
        column, row, tag, simulated ? "" : "not yet simulated");
    panels += column == 0 ? "set format y '%.2f'\nset ylabel 'height z [m]' offset 0.8,0\n"
                          : "set format y ''\nunset ylabel\n";
    if (!(longest > 0.0)) longest = 1.0;
    panels += fmt::format("set xrange [{:.3g}:{:.4g}]\nset xtics {:g}\n", -0.08 * longest, 1.15 * longest,
                          longest > 2.0   ? 1.0
                          : longest > 0.8 ? 0.5
                                          : 0.2);
    if (place + columns >= static_cast<int>(velocities.size()))
      panels += "set xlabel 'time since z = 0.2 m [s]' offset 0,0.4\n";
    panels += "plot " + plot + "\n";
    if (place == 0) panels += "eval footer_drawn\n";
    ++place;
  }
  // The key has the width of the picture, so it is a plot of its own; gnuplot's would wrap differently in each format.
  const std::string key =
      "set lmargin at screen left\nset rmargin at screen right\nset tmargin at screen 1 - 6.0/height\n"
      "set bmargin at screen 1 - 30.0/height\nunset title\nunset label 1\nunset border\nunset tics\nunset "
      "xlabel\nunset ylabel\n"
      "set arrow 1 from 0.00, 0.5 to 0.08, 0.5 nohead linecolor rgb pale_2 linewidth 2.2\nset label 11 'drops' at "
      "0.10, 0.5\n"
      "set arrow 2 from 0.28, 0.5 to 0.36, 0.5 nohead linecolor rgb '#003f63' linewidth 0.9\nset label 12 'straight "
      "lines' at "
      "0.38, 0.5\n"
      "set arrow 3 from 0.70, 0.5 to 0.78, 0.5 nohead linestyle 1\nset label 13 'paper' at 0.80, 0.5\n"
      "plot [0:1][0:1] NaN notitle\n";
  script += panels + key + "unset multiplot\n";
  draw_figure_of_runs("fig09", script, {780, 100 + 200 * rows}, context, keys);
  return output;
}

}  // namespace

Figure fig09() {
  return {"fig09", "Trajectories in the window of the velocity fit", needs, draw, "peng_2014/fig09_trajectories"};
}

}  // namespace slfb
