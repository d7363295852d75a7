#include "experiments/numerics/frontier/frontier_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "experiments/numerics/figures.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"

namespace slfb::frontier {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Columns of a method's table: the axis, then these (from 1, as gnuplot counts), then five of each quantity.
constexpr int time_column = 2, count_column = 3;
constexpr int first_quantity_column = 6, columns_of_quantity = 5, error_within_quantity = 2;
/// Of this machine's quick set: axis, the two costs, one error of each quantity.
constexpr int first_error_column_here = 4;

/// A label of an axis as a heading: with a unit.
std::string heading(const std::string& label) { return label.ends_with(']') ? label : label + " [-]"; }

/// Whether the point has an error that a logarithmic axis can show.
bool has_point(const ReducedPoint& point, const std::string& quantity) {
  const auto found = point.values.find(quantity);
  return point.failure.empty() && found != point.values.end() && found->second.error > 0.0 &&
         std::isfinite(found->second.error);
}

double count_of(const ReducedPoint& point, const std::string& count) {
  const auto found = point.counts.find(count);
  return found == point.counts.end() ? nothing : found->second;
}

/// What the tables and the panels of a chart are made of.
struct Chart {
  std::string id;
  const Study& study;
  const studies::Problem& problem;
  const ReducedStudy& reduced;
  const ReducedStudy& beside;           ///< this machine's quick set, or no points
  std::vector<std::string> quantities;  ///< of which some point has an error
  std::vector<std::string> failures;    ///< each reason once; its number is its place, from 1
  std::vector<std::string> tables;      ///< of the methods
  std::filesystem::path folder;

  [[nodiscard]] std::string title(const std::string& quantity) const {
    return studies::find_quantity(problem, quantity).title;
  }
  [[nodiscard]] std::string cost_label(bool by_count) const {
    return by_count ? fmt::format("{} per {}", study.count, problem.cost_unit)
                    : fmt::format("CPU seconds per {}", problem.cost_unit);
  }
  [[nodiscard]] std::string front_table(const std::string& quantity, bool by_count) const {
    return fmt::format("{}_front_{}{}", id, quantity, by_count ? "_by_count" : "");
  }
  [[nodiscard]] double cost(const ReducedPoint& point, bool by_count) const {
    return by_count ? count_of(point, study.count) : point.cpu_seconds;
  }
};

std::vector<std::string> headings_of(const Chart& chart) {
  std::vector<std::string> columns{heading(chart.study.axis_label),
                                   fmt::format("CPU time per {} [s]", chart.problem.cost_unit),
                                   fmt::format("{} per {} [-]", chart.study.count, chart.problem.cost_unit),
                                   "replicates [-]", "number of the reason of failure [-]"};
  for (const std::string& quantity : chart.quantities) {
    const auto& about = studies::find_quantity(chart.problem, quantity);
    for (const char* what : {"", " (half width of the 95 % interval)"})
      columns.push_back(fmt::format("{}{} [{}]", about.title, what, about.unit));
    for (const char* what : {"relative error", "relative error (low)", "relative error (high)"})
      columns.push_back(fmt::format("{} of {} [-]", what, about.title));
  }
  return columns;
}

/// One table a method: what is drawn, and no more.
void write_methods(Chart& chart, FigureOutput& output) {
  const auto columns = headings_of(chart);
  for (std::size_t s = 0; s < chart.study.series.size(); ++s) {
    DataTable table{fmt::format("{}_{}", chart.id, s), columns, {}};
    for (const ReducedPoint& point : chart.reduced.points) {
      if (point.series != chart.study.series[s]) continue;
      double reason = nothing;
      if (!point.failure.empty()) {
        auto known = std::ranges::find(chart.failures, point.failure);
        if (known == chart.failures.end()) known = chart.failures.insert(known, point.failure);
        reason = static_cast<double>(known - chart.failures.begin() + 1);
      }
      std::vector<double> row{point.axis, point.cpu_seconds, count_of(point, chart.study.count),
                              static_cast<double>(point.replicates), reason};
      for (const std::string& quantity : chart.quantities) {
        const auto found = point.values.find(quantity);
        const bool usable = point.failure.empty() && found != point.values.end() && found->second.error > 0.0;
        const PointValue value = usable ? found->second : PointValue{nothing, nothing, nothing, nothing};
        const double half = std::isfinite(value.error_half_width) ? value.error_half_width : 0.0;
        row.insert(row.end(), {value.value, value.half_width, value.error,
                               std::max(value.error - half, 0.1 * value.error), value.error + half});
      }
      table.rows.push_back(std::move(row));
    }
    chart.tables.push_back(table.name);
    output.data.push_back(write_csv(table, chart.folder));
  }
}

/// The points of this machine's quick set; not written without rows.
DataTable write_beside(const Chart& chart, FigureOutput& output) {
  auto columns = headings_of(chart);
  columns.resize(first_error_column_here - 1);
  DataTable here{chart.id + "_here", std::move(columns), {}};
  for (const std::string& quantity : chart.quantities)
    here.columns.push_back(fmt::format("relative error of {} [-]", chart.title(quantity)));
  for (const ReducedPoint& point : chart.beside.points) {
    std::vector<double> row{point.axis, point.cpu_seconds, count_of(point, chart.study.count)};
    for (const std::string& quantity : chart.quantities)
      row.push_back(has_point(point, quantity) ? point.values.at(quantity).error : nothing);
    here.rows.push_back(std::move(row));
  }
  if (!here.rows.empty()) output.data.push_back(write_csv(here, chart.folder));
  return here;
}

/// One quantity against one cost.
struct Panel {
  std::string title, x_label, front;
  bool first = false, has_front = false, has_here = false;
  int cost = time_column, error = 0, here = 0;  ///< columns
  double band = 0.0;                            ///< interval of the reference; 0: none
  double left = 0.0, right = 0.0;               ///< range of the cost
  double low = 0.0, high = 0.0, top = 0.0;      ///< range of the error, and where failures stand
  std::vector<double> drawn;                    ///< numbers of the methods that have points, from 1
};

Panel panel_of(const Chart& chart, std::size_t q, bool by_count, const DataTable& here, FigureOutput& output) {
  const std::string& quantity = chart.quantities[q];
  Panel panel;
  panel.title = chart.title(quantity);
  panel.x_label = chart.cost_label(by_count);
  panel.cost = by_count ? count_column : time_column;
  panel.error = first_quantity_column + columns_of_quantity * static_cast<int>(q) + error_within_quantity;
  panel.here = first_error_column_here + static_cast<int>(q);
  if (const auto reference = chart.reduced.reference.find(quantity);
      reference != chart.reduced.reference.end() && reference->second.error_half_width > 0.0)
    panel.band = reference->second.error_half_width;

  DataTable front{chart.front_table(quantity, by_count),
                  {headings_of(chart)[static_cast<std::size_t>(panel.cost) - 1], "relative error [-]"},
                  {}};
  for (const ReducedPoint* point : pareto_front(chart.reduced, quantity, by_count ? chart.study.count : ""))
    if (point->values.at(quantity).error > 0.0)
      front.rows.push_back({chart.cost(*point, by_count), point->values.at(quantity).error});
  output.data.push_back(write_csv(front, chart.folder));
  panel.front = front.name;
  panel.has_front = !front.rows.empty();

  double least_error = infinity, largest_error = 0.0, least_cost = infinity, largest_cost = 0.0;
  const auto include = [](double value, double& least, double& largest) {
    least = std::fmin(least, value);
    largest = std::fmax(largest, value);
  };
  for (std::size_t s = 0; s < chart.study.series.size(); ++s)
    if (std::ranges::any_of(chart.reduced.points, [&](const ReducedPoint& point) {
          return point.series == chart.study.series[s] && has_point(point, quantity) &&
                 std::isfinite(chart.cost(point, by_count));
        }))
      panel.drawn.push_back(static_cast<double>(s + 1));
  for (const ReducedPoint& point : chart.reduced.points) {
    if (has_point(point, quantity)) include(point.values.at(quantity).error, least_error, largest_error);
    if (has_point(point, quantity) || !point.failure.empty())
      include(chart.cost(point, by_count), least_cost, largest_cost);
  }
  for (const auto& row : here.rows) {
    const double error = row[static_cast<std::size_t>(panel.here) - 1];
    const double cost = row[static_cast<std::size_t>(panel.cost) - 1];
    if (!std::isfinite(error)) continue;
    include(error, least_error, largest_error);
    include(cost, least_cost, largest_cost);
    panel.has_here = panel.has_here || std::isfinite(cost);
  }
  panel.low = 0.4 * std::max(least_error, 1e-12);
  panel.high = 9.0 * largest_error;
  panel.top = 5.0 * largest_error;
  const bool one_cost = largest_cost < 1.01 * least_cost;
  panel.left = one_cost ? 0.5 * least_cost : std::pow(10.0, std::floor(std::log10(least_cost)));
  panel.right = one_cost ? 2.0 * largest_cost : std::pow(10.0, std::ceil(std::log10(largest_cost)));
  return panel;
}

void set_panels(const std::vector<Panel>& panels, PlotValues& values) {
  const auto texts = [&](const std::string& name, std::string Panel::*member) {
    std::vector<std::string> list;
    for (const Panel& panel : panels) list.push_back(panel.*member);
    values.texts(name, list);
  };
  const auto numbers = [&](const std::string& name, auto Panel::*member) {
    std::vector<double> list;
    for (const Panel& panel : panels) list.push_back(static_cast<double>(panel.*member));
    values.numbers(name, list);
  };
  texts("panel_title", &Panel::title);
  texts("panel_x_label", &Panel::x_label);
  std::vector<std::string> fronts;
  std::vector<double> drawn, drawn_end;
  for (const Panel& panel : panels) {
    fronts.push_back(panel.front);
    drawn.insert(drawn.end(), panel.drawn.begin(), panel.drawn.end());
    drawn_end.push_back(static_cast<double>(drawn.size()));
  }
  drawn.push_back(1.0);  // where a panel draws none, gnuplot reads the entry behind the last all the same
  values.files("panel_front", fronts);
  values.numbers("drawn", drawn);
  values.numbers("panel_drawn_end", drawn_end);
  numbers("panel_first", &Panel::first);
  numbers("panel_has_front", &Panel::has_front);
  numbers("panel_has_here", &Panel::has_here);
  numbers("panel_cost", &Panel::cost);
  numbers("panel_error", &Panel::error);
  numbers("panel_here", &Panel::here);
  numbers("panel_band", &Panel::band);
  numbers("panel_left", &Panel::left);
  numbers("panel_right", &Panel::right);
  numbers("panel_low", &Panel::low);
  numbers("panel_high", &Panel::high);
  numbers("panel_top", &Panel::top);
}

/// Lines below the panels, cut to the width of the picture.
std::vector<std::string> foot_of(const Chart& chart, int width) {
  std::vector<std::string> lines;
  if (!chart.study.reference_text.empty()) lines.push_back("Errors: " + chart.study.reference_text);
  lines.push_back(fmt::format("{} set, {}, {}.", chart.reduced.set, chart.reduced.machine, chart.reduced.date));
  for (std::size_t k = 0; k < chart.failures.size(); ++k)
    lines.push_back(fmt::format("x {}  failed: {}", k + 1, chart.failures[k]));
  const std::size_t longest = static_cast<std::size_t>(width) / 6;
  for (std::string& line : lines)
    if (line.size() > longest) line = line.substr(0, longest - 3) + "...";
  return lines;
}

/// Puts the panels on the page and draws it.
void draw(const Chart& chart, const std::vector<Panel>& panels, const DataTable& here, int rows, int columns) {
  const int width = columns == 1 ? 620 : 330 * columns + 60;
  const auto lines = foot_of(chart, width);
  const int key_rows = here.rows.empty() ? 2 : 3;
  const int head = 32 + 17 * key_rows, foot = 16 * static_cast<int>(lines.size()) + 10;
  const int height = 290 * rows + head + foot;
  std::vector<double> positions;
  for (std::size_t k = 0; k < lines.size(); ++k)
    positions.push_back((foot - 4.0 - 16.0 * (static_cast<double>(k) + 0.5)) / height);
  std::vector<std::string> failed;
  for (std::size_t s = 0; s < chart.tables.size(); ++s)
    if (std::ranges::any_of(chart.reduced.points, [&](const ReducedPoint& point) {
          return point.series == chart.study.series[s] && !point.failure.empty();
        }))
      failed.push_back(chart.tables[s]);
  PlotValues values;
  values.number("page_rows", rows);
  values.number("page_columns", columns);
  values.number("page_left", 78.0 / width);
  values.number("page_bottom", (foot + 68.0) / height);
  values.number("page_top", 1.0 - (head + 20.0) / height);
  values.number("page_gap", 108.0 / height);
  values.number("key_rows", key_rows);
  values.files("series", chart.tables);
  values.texts("series_title", chart.study.series);
  values.files("failed", failed);
  values.files("here", here.rows.empty() ? std::vector<std::string>{} : std::vector{here.name});
  values.texts("foot", lines);
  values.numbers("foot_position", positions);
  set_panels(panels, values);
  draw_plot(chart.id, source_folder() / "experiments/numerics/frontier/chart.gp", values, {width, height},
            chart.folder);
}

}  // namespace

FigureOutput draw_frontier(const Study& study, const ReducedStudy& reduced, const ReducedStudy& beside,
                           const std::filesystem::path& folder) {
  const std::string id = "frontier-" + study.id;
  if (reduced.points.empty()) return not_yet_computed(id, study.caption, "slfb frontier " + study.id, folder);
  FigureOutput output{id, {}, study.caption, {}};
  Chart chart{id, study, studies::find_problem(study.problem), reduced, beside, {}, {}, {}, folder};
  for (const std::string& quantity : study.quantities)
    if (std::ranges::any_of(reduced.points, [&](const ReducedPoint& point) { return has_point(point, quantity); }))
      chart.quantities.push_back(quantity);
  write_methods(chart, output);
  const DataTable here = write_beside(chart, output);
  const std::size_t quantities = chart.quantities.size();
  const bool both_costs = quantities <= 3;
  const std::size_t columns = std::min<std::size_t>(quantities > 6 ? 4 : 3, quantities);
  std::vector<Panel> panels;
  // What no machine changes above, the time of this machine below.
  for (const bool by_count : both_costs ? std::vector{true, false} : std::vector{false})
    for (std::size_t q = 0; q < quantities; ++q) {
      panels.push_back(panel_of(chart, q, by_count, here, output));
      panels.back().first = q % columns == 0;
    }
  const std::size_t rows = both_costs ? 2 : (quantities + columns - 1) / columns;
  draw(chart, panels, here, static_cast<int>(rows), static_cast<int>(columns));
  output.notes.push_back(
      fmt::format("{} set of `slfb frontier {}`, {}, {}.", reduced.set, study.id, reduced.machine, reduced.date));
  if (!here.rows.empty())
    output.notes.push_back(
        fmt::format("Circles: quick set, {}, {}; against its own reference.", beside.machine, beside.date));
  for (std::size_t k = 0; k < chart.failures.size(); ++k)
    output.notes.push_back(fmt::format("Failed (x {}): {}", k + 1, chart.failures[k]));
  if (!study.default_text.empty()) output.notes.push_back("The suite's default: " + study.default_text);
  return output;
}

}  // namespace slfb::frontier

namespace slfb {

namespace {

/// Whoever draws the figure meets the error of a damaged file; the other figures and commands do not.
std::string title_of(const std::filesystem::path& file) {
  try {
    return frontier::load_study(file, studies::Set::full).title;
  } catch (const std::exception&) {
    return file.filename().string() + " (cannot be read)";
  }
}

}  // namespace

std::vector<Figure> frontier_charts() {
  std::vector<Figure> list;
  for (const auto& file : frontier::study_files())
    list.push_back({"frontier-" + file.stem().string(), title_of(file), no_runs,
                    [file](const FigureContext& context) {
                      const auto study = frontier::load_study(file, studies::Set::full);
                      return frontier::draw_frontier(study, frontier::load_reduced(study, context.results),
                                                     frontier::load_beside(study, context.results), context.out);
                    },
                    "numerics/frontier"});
  return list;
}

}  // namespace slfb
