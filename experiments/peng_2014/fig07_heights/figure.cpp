#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::fig07_heights {
namespace {

const FigureFolder folder{"peng_2014/fig07_heights"};

constexpr const char* system_name = "6in5W";
constexpr std::array velocities{0.03, 0.04, 0.05, 0.06, 0.07};  ///< around minimum fluidisation [m/s]

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.system == system_name && spec.variant.empty() &&
           std::any_of(velocities.begin(), velocities.end(),
                       [&](double velocity) { return std::fabs(velocity - spec.superficial_velocity) < 1e-6; });
  });
}

/// Heights of all drops at one velocity; told apart by their number.
DataTable heights(const FigureContext& context, const std::string& key, const std::string& name) {
  DataTable table{name, {"drop [-]", "time since release [s]", "height of the centre [m]"}, {}};
  double number = 0.0;
  const FinishedRun* run = find_run(context, key);
  if (run == nullptr) return table;
  for (const auto& drop : run->result.drops) {
    ++number;
    double last = -1.0;
    for (std::size_t i = 0; i < drop.time.size(); ++i) {
      if (drop.time[i] - last < 0.0199 && i + 1 < drop.time.size()) continue;
      last = drop.time[i];
      table.rows.push_back({number, drop.time[i], drop.z[i]});
    }
  }
  return table;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig07",
                      {},
                      folder.caption({{"packed_height", fmt::format("{}", printed.value("packed_height"))},
                                      {"followed", fmt::format("{:g}", printed.value("followed_time"))},
                                      {"settling_0.06", fmt::format("{}", printed.value("settling_time_0.06"))},
                                      {"settling_0.07", fmt::format("{}", printed.value("settling_time_0.07"))}}),
                      run_notes(context, keys)};
  output.data.push_back(write_csv(
      {"fig07_paper",
       {"superficial velocity [m/s]", "time of arrival [s]", "height of the centre [m]"},
       {{0.06, printed.value("settling_time_0.06"), 0.003}, {0.07, printed.value("settling_time_0.07"), 0.003}}},
      context.out));
  std::vector<std::string> key_entries, tables;
  std::vector<double> numbers, places;
  for (std::size_t place = 0; place < velocities.size(); ++place) {
    const std::string tag = fmt::format("{:.2f}", velocities[place]);
    const DataTable table = heights(context, fmt::format("{}/{}", system_name, tag), "fig07_drops_" + tag);
    key_entries.push_back(fmt::format("{} m/s{}", tag, table.rows.empty() ? ", not yet simulated" : ""));
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, context.out));
    const int drops = static_cast<int>(table.rows.back()[0]);
    for (int drop = 1; drop <= drops; ++drop) {
      tables.push_back(table.name);
      numbers.push_back(drop);
      places.push_back(static_cast<double>(place + 1));
    }
  }
  PlotValues values;
  values.number("followed_time", printed.value("followed_time"));
  values.number("packed_height", printed.value("packed_height"));
  values.number("arrival", printed.value("settling_time_0.06"));
  values.texts("velocity", key_entries);
  values.files("drop", tables);
  values.numbers("drop_number", numbers);
  values.numbers("drop_velocity", places);
  draw_plot_of_runs("fig07", folder.plot(), values, {560, 430}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig07", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig07_heights
