#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/league/contenders.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"
#include "experiments/richardson_zaki_1954/figures.hpp"
#include "experiments/richardson_zaki_1954/numbers.hpp"
#include "experiments/richardson_zaki_1954/simulations.hpp"

namespace slfb::richardson_zaki::expansion {
namespace {

const FigureFolder folder{"richardson_zaki_1954/expansion"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile,
                         [](const RunSpec& spec) { return spec.variant.empty() || spec.variant == one_dimensional; });
}

DataTable simulated(const FigureContext& context, const std::string& bed, const std::string& variant) {
  DataTable table{fmt::format("expansion_{}_{}", bed, variant.empty() ? "three-dimensional" : variant),
                  {"superficial velocity [m/s]", "voidage [-]", "half width of its 95 % interval [-]"},
                  {}};
  for (const MeasuredPoint& point : measured_points(context.measurements, "voidage_centre_of_mass", bed, variant))
    table.rows.push_back({point.superficial_velocity, point.value, point.half_width});
  return table;
}

/// Errors of simulated voidages against the measured lines.
class Errors {
 public:
  /// \param row superficial velocity [m/s] and voidage [-]
  void add(const ExpansionLine& line, const std::vector<double>& row) {
    const double error = row[1] - std::pow(row[0] / line.intercept, 1.0 / line.exponent);
    sum_ += error;
    squares_ += error * error;
    worst_ = std::max(worst_, std::abs(error));
    ++points_;
  }
  [[nodiscard]] std::string text() const {
    return points_ == 0 ? "not yet simulated"
                        : fmt::format("{:+.3f} in the mean, {:.3f} root mean square, at most {:.3f} ({} runs)",
                                      sum_ / points_, std::sqrt(squares_ / points_), worst_, points_);
  }

 private:
  double sum_ = 0.0, squares_ = 0.0, worst_ = 0.0;
  int points_ = 0;
};

/// Smallest and largest of what two models differ by.
class Differences {
 public:
  void add(double difference) {
    smallest_ = std::min(smallest_, difference);
    largest_ = std::max(largest_, difference);
    ++count_;
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:+.3f} to {:+.3f}", smallest_, largest_); }
  [[nodiscard]] int count() const { return count_; }

 private:
  double smallest_ = HUGE_VAL, largest_ = -HUGE_VAL;
  int count_ = 0;
};

/// What the width of a model and its dimensions do to the voidage, where one bed has all three models at one velocity.
std::string width_text(const FigureContext& context) {
  Differences by_width, by_dimension;
  for (const ExpansionLine& line : beds())
    for (const auto& narrow : simulated(context, line.name, in_narrower_box).rows) {
      const auto at_same_velocity = [&](const std::string& variant) -> std::optional<double> {
        for (const auto& row : simulated(context, line.name, variant).rows)
          if (row[0] == narrow[0]) return row[1];
        return std::nullopt;
      };
      const auto box = at_same_velocity(""), slice = at_same_velocity(one_dimensional);
      if (!box || !slice) continue;
      by_width.add(narrow[1] - *box);
      by_dimension.add(*slice - narrow[1]);
    }
  if (by_width.count() == 0) return "";
  return fmt::format(
      " In a box of six diameters in three dimensions the voidage is {} from that in ten diameters, in a slice of six "
      "diameters {} from that in the box of the same width ({} beds).",
      by_width.text(), by_dimension.text(), by_width.count());
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"expansion", {}, "", run_notes(context, keys)};
  const auto all = league::contenders();
  const league::Contender& law = league::find_contender(all, scene_law);
  const league::Contender& formula = league::find_contender(all, authors_formula());
  std::vector<std::string> names, lines, laws, slices, columns;
  std::vector<double> low, high;
  Errors in_slices, in_columns;
  for (const ExpansionLine& line : beds()) {
    DataTable measured{"expansion_" + line.name, {"voidage [-]", "superficial velocity [m/s]"}, {}};
    DataTable theory{"expansion_" + line.name + "_laws",
                     {"voidage [-]", fmt::format("superficial velocity by {} [m/s]", law.name()),
                      fmt::format("superficial velocity by {} [m/s]", formula.name())},
                     {}};
    const league::Bed bed = league::bed_of(line);
    for (int step = 42; step <= 100; ++step) {
      const double voidage = 0.01 * step;
      measured.rows.push_back({voidage, line.velocity(voidage)});
      theory.rows.push_back({voidage, law.velocity(bed, voidage), formula.velocity(bed, voidage)});
    }
    const DataTable slice = simulated(context, line.name, one_dimensional);
    const DataTable column = simulated(context, line.name, "");
    for (const auto& row : slice.rows) in_slices.add(line, row);
    for (const auto& row : column.rows) in_columns.add(line, row);
    for (const DataTable* table : {&measured, &theory}) output.data.push_back(write_csv(*table, context.out));
    for (const DataTable* table : {&slice, &column})
      if (!table->rows.empty()) output.data.push_back(write_csv(*table, context.out));
    names.push_back(line.name);
    lines.push_back(measured.name);
    laws.push_back(theory.name);
    slices.push_back(slice.rows.empty() ? "" : slice.name);
    columns.push_back(column.rows.empty() ? "" : column.name);
    low.push_back(0.7 * line.velocity(0.5));
    high.push_back(1.2 * line.intercept);
  }
  output.caption = folder.caption(
      {{"agreement",
        fmt::format("Errors of the voidage: three dimensions {}; slices {}. Two columns of the measurements "
                    "differ by {:.3f}.{}",
                    in_columns.text(), in_slices.text(), 2.0 * voidage_band(), width_text(context))}});
  PlotValues values;
  values.texts("name", names);
  values.files("measured", lines);
  values.files("laws", laws);
  values.files("simulated_1", slices);
  values.files("simulated_3", columns);
  values.numbers("low", low);
  values.numbers("high", high);
  values.text("law_title", law.name());
  values.text("formula_title", formula.name());
  draw_plot_of_runs("expansion", folder.plot(), values, {1100, 820}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"expansion", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::richardson_zaki::expansion
