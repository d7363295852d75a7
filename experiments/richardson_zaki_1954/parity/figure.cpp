#include <fmt/format.h>

#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/league/standings.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"
#include "experiments/richardson_zaki_1954/figures.hpp"
#include "experiments/richardson_zaki_1954/numbers.hpp"
#include "experiments/richardson_zaki_1954/simulations.hpp"

namespace slfb::richardson_zaki::parity {
namespace {

const FigureFolder folder{"richardson_zaki_1954/parity"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile,
                         [](const RunSpec& spec) { return spec.variant.empty() || spec.variant == one_dimensional; });
}

DataTable table_named(const std::string& name) {
  return {"parity_" + name, {"measured voidage [-]", "our voidage [-]", "half width of its 95 % interval [-]"}, {}};
}

DataTable simulated(const FigureContext& context, const std::string& name, const std::string& variant) {
  DataTable table = table_named(name);
  for (const ExpansionLine& line : beds())
    for (const MeasuredPoint& point :
         measured_points(context.measurements, "voidage_centre_of_mass", line.name, variant))
      table.rows.push_back(
          {std::pow(point.superficial_velocity / line.intercept, 1.0 / line.exponent), point.value, point.half_width});
  return table;
}

/// Beside one another, not on one another.
DataTable homogeneous(const FigureContext& context, const std::string& name, const std::string& law, double shift) {
  DataTable table = table_named(name);
  for (const ExpansionLine& line : beds())
    for (const double voidage : league::line_voidages)
      table.rows.push_back(
          {voidage + shift,
           context.measurements.at(measure_key("homogeneous_voidage", law, run_velocity(line, voidage), line.name))
               .value,
           std::nan("")});
  return table;
}

std::string error_text(const DataTable& table, double shift) {
  double squares = 0.0, worst = 0.0;
  for (const auto& row : table.rows) {
    const double error = row[1] - row[0] + shift;
    squares += error * error;
    worst = std::max(worst, std::abs(error));
  }
  return fmt::format("{:.3f} and at most {:.3f} ({} points)",
                     std::sqrt(squares / static_cast<double>(table.rows.size())), worst, table.rows.size());
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"parity", {}, "", run_notes(context, keys)};
  constexpr double shift = 0.008;
  const std::vector<Series> series{{simulated(context, "slice", one_dimensional), "simulated, 1-D slice", 2},
                                   {simulated(context, "three-dimensional", ""), "simulated, 3-D", 3},
                                   {homogeneous(context, "law", scene_law, shift), scene_law, 4},
                                   {homogeneous(context, "formula", authors_formula(), -shift), authors_formula(), 5}};
  std::string agreement = "Errors, root mean square and largest: ";
  const double shifts[] = {0.0, 0.0, shift, -shift};
  bool first = true;
  for (std::size_t i = 0; i < series.size(); ++i)
    if (!series[i].table.rows.empty())
      agreement +=
          (std::exchange(first, false) ? "" : "; ") + series[i].title + " " + error_text(series[i].table, shifts[i]);
  output.caption = folder.caption({{"agreement", agreement + "."}});
  PlotValues values;
  add_series("series", series, values, context, output);
  values.number("band", 2.0 * voidage_band());
  draw_plot_of_runs("parity", folder.plot(), values, {560, 560}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"parity", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::richardson_zaki::parity
