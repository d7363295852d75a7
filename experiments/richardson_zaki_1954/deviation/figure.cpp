#include <fmt/format.h>

#include <algorithm>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/league/standings.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"
#include "experiments/richardson_zaki_1954/figures.hpp"
#include "experiments/richardson_zaki_1954/numbers.hpp"

namespace slfb::richardson_zaki::deviation {
namespace {

const FigureFolder folder{"richardson_zaki_1954/deviation"};

/// Mean, smallest and largest error of the voidage of a bed.
struct Errors {
  double mean, smallest, largest;
};
Errors errors_of(const FigureContext& context, const ExpansionLine& line, const std::string& law) {
  Errors errors{0.0, 1.0, -1.0};
  for (const double voidage : league::line_voidages) {
    const double error =
        context.measurements.at(measure_key("homogeneous_voidage", law, run_velocity(line, voidage), line.name)).value -
        voidage;
    errors.mean += error / static_cast<double>(std::size(league::line_voidages));
    errors.smallest = std::min(errors.smallest, error);
    errors.largest = std::max(errors.largest, error);
  }
  return errors;
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"deviation", {}, "", {}};
  const std::vector<std::string> laws{authors_formula(), scene_law, "wen-yu-1966 + wall", "gidaspow-1994"};
  std::vector<Series> series;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    DataTable table{
        fmt::format("deviation_{}", laws[i].substr(0, laws[i].find(' '))),
        {"terminal Reynolds number [-]", "mean error of the voidage [-]", "smallest error [-]", "largest error [-]"},
        {}};
    for (const ExpansionLine& line : beds()) {
      const Errors errors = errors_of(context, line, laws[i]);
      table.rows.push_back(
          {league::terminal_reynolds(league::bed_of(line)), errors.mean, errors.smallest, errors.largest});
    }
    series.push_back({std::move(table), laws[i], static_cast<int>(i) + 2});
  }
  double wide = 0.0, narrow = 0.0;
  int wide_count = 0, narrow_count = 0;
  for (const ExpansionLine& line : beds()) {
    const double mean = errors_of(context, line, scene_law).mean;
    (line.diameter_ratio() < 0.04 ? wide : narrow) += mean;
    ++(line.diameter_ratio() < 0.04 ? wide_count : narrow_count);
  }
  output.caption = folder.caption(
      {{"trend", fmt::format("The drag law {} as it is errs by {:+.3f} in the mean in tubes of more than 25 diameters "
                             "and by {:+.3f} in narrower ones, where the wall holds the liquid back.",
                             scene_law, wide / wide_count, narrow / narrow_count)}});
  PlotValues values;
  add_series("series", series, values, context, output);
  values.number("band", 2.0 * voidage_band());
  draw_plot("deviation", folder.plot(), values, {620, 460}, context.out);
  return output;
}

}  // namespace

Figure figure() { return {"deviation", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::richardson_zaki::deviation
