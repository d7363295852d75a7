#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig09_trajectories {
namespace {

const FigureFolder folder{"peng_2014/fig09_trajectories"};

bool wanted(const RunSpec& spec) { return spec.system == "6in5W" && spec.variant.empty(); }

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return wanted(spec) && spec.superficial_velocity > 0.055;  // below, the paper fits no line
  });
}

/// Samples and fitted lines of all drops at one velocity, on a clock that reads zero where the line passes the top of
/// the window. Returns whether there is any.
bool tabulate(const FigureContext& context, double velocity, DataTable& samples, DataTable& fits) {
  const auto [window_bottom, window_top] = *peng_2014_work().measuring.classification_window;
  int number = 0;
  const std::string key = run_key("6in5W", velocity);
  for (const auto& run : context.runs) {
    if (run_key(run.spec) != key) continue;
    for (const auto& drop : run.result.drops) {
      const auto fit = classification_of(drop, run.scene, peng_2014_work().measuring);
      if (!fit || fit->velocity <= 0.0) continue;
      ++number;
      const double origin = (fit->intercept - window_top) / fit->velocity;
      const double margin = 0.01;  // of height, shown above and below the window [m]
      double last_time = -1.0;
      for (std::size_t i = 0; i < drop.time.size(); ++i) {
        if (drop.z[i] < window_bottom - margin) break;
        // 200 points a second are enough for the eye and keep the SVG small.
        if (drop.z[i] > window_top + margin || drop.time[i] - last_time < 0.0049) continue;
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
  const auto [window_bottom, window_top] = *peng_2014_work().measuring.classification_window;
  const std::string top = fmt::format("{:.1f}", window_top);
  FigureOutput output{"fig09",
                      {},
                      folder.caption({{"bottom", fmt::format("{:.1f}", window_bottom)}, {"top", top}}),
                      run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::velocity}, context, output);

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
  std::vector<std::string> tags, tables;
  std::vector<double> first_drops, drop_counts, slopes, paper_slopes, longest_times;
  for (const double velocity : velocities) {
    const std::string tag = fmt::format("{:.2f}", velocity);
    DataTable samples{"fig09_drops_" + tag, {"drop [-]", "time since the line passes 0.2 m [s]", "height [m]"}, {}};
    DataTable fits{"fig09_fits_" + tag,
                   {"drop [-]", "classification velocity [m/s]", "R^2 [-]", "release on the clock of the bed [s]"},
                   {}};
    double longest = 0.0;  // time that a straight line takes through the window
    tags.push_back(tag);
    tables.emplace_back();
    first_drops.push_back(static_cast<double>(slopes.size() + 1));
    if (tabulate(context, velocity, samples, fits)) {
      output.data.push_back(write_csv(samples, context.out));
      output.data.push_back(write_csv(fits, context.out));
      tables.back() = samples.name;
      for (const auto& row : fits.rows) {
        slopes.push_back(row[1]);
        longest = std::max(longest, 0.1 / row[1]);
      }
    }
    drop_counts.push_back(static_cast<double>(fits.rows.size()));
    const auto& table2 = peng_2014().table2();
    const auto printed = std::find_if(table2.begin(), table2.end(), [&](const Table2Row& row) {
      return std::fabs(row.superficial_velocity - velocity) < 1e-6;
    });
    if (printed != table2.end()) longest = std::max(longest, 0.1 / printed->classification_velocity);
    paper_slopes.push_back(printed != table2.end() ? printed->classification_velocity : std::nan(""));
    longest_times.push_back(longest > 0.0 ? longest : 1.0);
  }
  PlotValues values;
  values.number("columns", columns);
  values.number("rows", rows);
  values.texts("velocity", tags);
  values.files("samples", tables);
  values.numbers("first_drop", first_drops);
  values.numbers("drops", drop_counts);
  values.numbers("longest", longest_times);
  values.numbers("paper_slope", paper_slopes);
  values.numbers("slope", slopes);
  draw_plot_of_runs("fig09", folder.plot(), values, {780, 100 + 200 * rows}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig09", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig09_trajectories
