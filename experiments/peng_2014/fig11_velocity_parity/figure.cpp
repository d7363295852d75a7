#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig11_velocity_parity {
namespace {

const FigureFolder folder{"peng_2014/fig11_velocity_parity"};

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

/// Correlations with a single value, in the order of their columns.
constexpr std::array models{"kunii-levenspiel-1969", "di-felice-1991", "kennedy-bretton-1966",
                            "joshi-1983-reconstruction", "van-der-wielen-1996"};

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const auto& table2 = peng_2014().table2();
  FigureOutput output{"fig11", {}, folder.caption(), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::velocity, grid_convergence::voidage}, context, output);

  DataTable laws{"fig11_laws", {"superficial velocity [m/s]", "classification velocity of Table 2 [m/s]"}, {}};
  for (const char* model : models) laws.columns.push_back(fmt::format("{} [m/s]", model));
  for (const char* end : {"lower", "upper"}) laws.columns.push_back(fmt::format("grbavcic-2009 {} [m/s]", end));
  for (const auto& row : table2) {
    std::vector<double> values{row.superficial_velocity, row.classification_velocity};
    const auto value = [&](const char* quantity, const char* law) {
      return context.measurements.at(measure_key(quantity, law, row.superficial_velocity)).value;
    };
    for (const char* model : models) values.push_back(value("classification_velocity", model));
    values.push_back(value("classification_velocity_lower", "grbavcic-2009"));
    values.push_back(value("classification_velocity_upper", "grbavcic-2009"));
    laws.rows.push_back(values);
  }
  std::sort(laws.rows.begin(), laws.rows.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  output.data.push_back(write_csv(laws, context.out));

  std::vector<Series> simulated;
  const auto variants = variants_of(context.profile, system_name);
  for (std::size_t k = 0; k < variants.size(); ++k) {
    DataTable table{"fig11_simulated_" + (variants[k].empty() ? std::string("default") : variants[k]),
                    {"superficial velocity [m/s]", "classification velocity of Table 2 [m/s]",
                     "simulated classification velocity [m/s]", "half width of its 95 % interval [m/s]"},
                    {}};
    for (const auto& point : measured_points(context.measurements, "classification_velocity", system_name, variants[k]))
      for (const auto& row : table2)
        if (std::fabs(row.superficial_velocity - point.superficial_velocity) < 1e-6)
          table.rows.push_back({row.superficial_velocity, row.classification_velocity, point.value, point.half_width});
    simulated.push_back({std::move(table), series_title(context, system_name, variants[k]), line_style(k)});
  }
  PlotValues values;
  add_series("simulated", simulated, values, context, output);
  draw_plot_of_runs("fig11", folder.plot(), values, {560, 560}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig11", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig11_velocity_parity
