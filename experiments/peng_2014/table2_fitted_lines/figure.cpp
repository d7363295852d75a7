#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::table2_fitted_lines {
namespace {

const std::vector<std::pair<std::string, std::string>> headings{
    {"U_L", "[m/s]"},      {"V_2 [m/s]", "paper"},     {"V_2 [m/s]", "ours"},
    {"V_2", "difference"}, {"intercept [m]", "paper"}, {"intercept [m]", "ours"},
    {"R² [-]", "paper"},   {"R² [-]", "ours"},         {"", "drops"}};

const FigureFolder folder{"peng_2014/table2_fitted_lines"};

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) {
  return spec.system == system_name && spec.variant.empty() && spec.superficial_velocity > 0.055;
}

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

/// "0.213 ± 0.021", the value alone for a single sample, a dash for none.
std::string with_interval(const Measurement& measured, int digits) {
  if (std::isnan(measured.value)) return "–";
  if (!std::isfinite(measured.half_width)) return fmt::format("{:.{}f}", measured.value, digits);
  return fmt::format("{:.{}f} ± {:.{}f}", measured.value, digits, measured.half_width, digits);
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"table2", {}, folder.caption(), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::velocity}, context, output);
  DataTable table{"table2_lines",
                  {"superficial velocity [m/s]", "paper V_2 [m/s]", "V_2 [m/s]",
                   "half width of its 95 % interval [m/s]", "paper intercept [m]", "intercept [m]",
                   "half width of its 95 % interval [m]", "paper R^2 [-]", "R^2 [-]", "drops [-]"},
                  {}};
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : peng_2014().table2()) {
    const auto measured = [&](const char* quantity) {
      const auto found = context.measurements.find(measure_key(quantity, system_name, row.superficial_velocity));
      return found == context.measurements.end() ? Measurement{} : found->second;
    };
    const Measurement velocity = measured("classification_velocity"), intercept = measured("classification_intercept"),
                      r_squared = measured("classification_r2");
    const bool simulated = !std::isnan(velocity.value);
    const double drops = simulated ? static_cast<double>(velocity.samples) : 0.0;
    table.rows.push_back({row.superficial_velocity, row.classification_velocity, velocity.value, velocity.half_width,
                          row.intercept, intercept.value, intercept.half_width, row.r_squared, r_squared.value, drops});
    rows.push_back(
        {fmt::format("{:.2f}", row.superficial_velocity), fmt::format("{:.3f}", row.classification_velocity),
         with_interval(velocity, 3),
         simulated ? fmt::format("{:+.0f} %", 100.0 * (velocity.value / row.classification_velocity - 1.0)) : "–",
         fmt::format("{:.3f}", row.intercept), with_interval(intercept, 2), fmt::format("{:.4g}", row.r_squared),
         simulated ? fmt::format("{:.4f}", r_squared.value) : "–", fmt::format("{:g}", drops)});
  }
  output.data.push_back(write_csv(table, context.out));
  PlotValues values;
  output.table = {headings, std::move(rows)};
  const int height = add_table(output.table, values);
  draw_plot_of_runs("table2", folder.plot(), values, {760, height}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"table2", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::table2_fitted_lines
