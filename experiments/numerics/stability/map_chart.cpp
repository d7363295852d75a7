#include "experiments/numerics/stability/map_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "experiments/numerics/figures.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"

namespace slfb::stability {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Columns of a method's table, from 1; the limits of theory follow.
constexpr int boundary_column = 2, open_column = 5, first_theory_column = 6;

/// A label of an axis as a heading: with a unit.
std::string heading(const std::string& label) { return label.ends_with(']') ? label : label + " [-]"; }

/// Range that grows with the values that are put in.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// A limit of theory as a curve of the map.
struct TheoryCurve {
  std::string table, title;
  int column;
  std::size_t series;  ///< number of the method whose colour it has, from 1; 0: one for all methods
  int dash;            ///< dash type of map.gp
};

/// Whether the limit is the same for all methods wherever two of them are at one x.
bool is_common(const SolvedMap& solved, std::size_t theory) {
  for (const Boundary& a : solved.boundaries)
    for (const Boundary& b : solved.boundaries)
      if (a.x == b.x && std::isfinite(a.theory[theory]) && std::isfinite(b.theory[theory]) &&
          std::abs(a.theory[theory] / b.theory[theory] - 1.0) > 1e-6)
        return false;
  return true;
}

DataTable table_of(const Map& map, const SolvedMap& solved, std::size_t series, Range& y) {
  DataTable table{
      fmt::format("stability-{}_{}", map.id, series),
      {heading(map.x_label), heading(map.y_label), "bracket (low) [-]", "bracket (high) [-]", "no boundary up to [-]"},
      {}};
  for (const Theory& theory : map.theories) table.columns.push_back(theory.name + " [-]");
  for (const Boundary& b : solved.boundaries) {
    if (b.series != map.series[series].name) continue;
    const bool found = b.kind == BoundaryKind::found;
    std::vector<double> row{b.x, found ? b.y : nothing, found ? b.low : nothing, found ? b.high : nothing,
                            found ? nothing : b.y};
    for (const double value : b.theory) {
      row.push_back(value);
      if (value > 0.0) y.include(value);
    }
    y.include(b.y);
    table.rows.push_back(std::move(row));
  }
  return table;
}

bool has_number(const DataTable& table, int column) {
  return std::ranges::any_of(table.rows,
                             [&](const auto& row) { return std::isfinite(row[static_cast<std::size_t>(column) - 1]); });
}

/// gnuplot's format of the ticks of an axis; empty for its own.
std::string y_format(const Range& y) {
  if (y.high / y.low > 50.0) return "10^{%L}";
  return y.low < 1e-3 ? "%.0e" : "";
}

void set_axes(const Map& map, const SolvedMap& solved, const Range& y, PlotValues& values) {
  Range x;
  x.include(map.x_values.front());
  for (const Boundary& b : solved.boundaries) x.include(b.x);
  for (const Map::Mark& mark : map.marks) x.include(mark.x);
  const double margin = 0.05 * (x.high - x.low);
  values.number("x_log", map.x_logarithmic);
  values.number("x_low", map.x_logarithmic ? x.low / 1.3 : x.low - margin);
  values.number("x_high", map.x_logarithmic ? x.high * 1.3 : x.high + margin);
  values.markup("x_format", map.x_logarithmic && x.high / x.low > 50.0 ? "10^{%L}" : "");
  values.number("y_low", y.low / 1.8);
  values.number("y_high", y.high * 1.8);
  values.markup("y_format", y_format(y));
  values.text("x_label", map.x_label);
  values.text("y_label", map.y_label);
  values.number("middle", std::sqrt(map.y_low * map.y_high));
  values.number("fails_high", map.fails_high);
  std::vector<double> mark_x, mark_y, mark_right;
  std::vector<std::string> mark_text;
  for (const Map::Mark& mark : map.marks) {
    mark_x.push_back(mark.x);
    mark_y.push_back(mark.y);
    mark_text.push_back(mark.text);
    mark_right.push_back(mark.x > 0.7 * x.high);
  }
  values.numbers("mark_x", mark_x);
  values.numbers("mark_y", mark_y);
  values.texts("mark_text", mark_text);
  values.numbers("mark_right", mark_right);
}

void set_theories(const std::vector<TheoryCurve>& curves, PlotValues& values) {
  std::vector<std::string> tables, titles;
  std::vector<double> columns, series, dashes;
  for (const TheoryCurve& curve : curves) {
    tables.push_back(curve.table);
    titles.push_back(curve.title);
    columns.push_back(curve.column);
    series.push_back(static_cast<double>(curve.series));
    dashes.push_back(curve.dash);
  }
  values.files("theory", tables);
  values.texts("theory_title", titles);
  values.numbers("theory_column", columns);
  values.numbers("theory_series", series);
  values.numbers("theory_dash", dashes);
}

std::vector<std::string> notes_of(const Map& map, const SolvedMap& solved) {
  std::vector<std::string> notes;
  std::set<std::string> described;
  for (const Boundary& b : solved.boundaries) {
    if (b.kind == BoundaryKind::always_fails)
      notes.push_back(fmt::format("{} at {:g}: fails in the whole range ({}).", b.series, b.x, b.diagnosis));
    else if (b.kind == BoundaryKind::found && described.insert(b.series).second)
      notes.push_back(fmt::format("{}: beyond the boundary {}.", b.series, b.diagnosis));
  }
  notes.push_back(fmt::format("{} set of `slfb stability {}`, {}.", solved.set, map.id, solved.date));
  return notes;
}

}  // namespace

FigureOutput draw_map(const Map& map, const SolvedMap& solved, const SolvedMap& beside,
                      const std::filesystem::path& folder) {
  const std::string id = "stability-" + map.id;
  const std::string caption = map.caption + " Fails: " + map.criterion_text + ".";
  if (solved.boundaries.empty()) return not_yet_computed(id, caption, "slfb stability " + map.id, folder);
  FigureOutput output{id, {}, caption, notes_of(map, solved)};
  Range y;
  std::vector<std::string> tables, titles;
  std::vector<double> bracketed, open;
  std::vector<TheoryCurve> theories;
  std::set<std::string> titled;
  for (std::size_t s = 0; s < map.series.size(); ++s) {
    const DataTable table = table_of(map, solved, s, y);
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, folder));
    tables.push_back(table.name);
    titles.push_back(map.series[s].name);
    const std::size_t number = tables.size();
    if (has_number(table, boundary_column)) bracketed.push_back(static_cast<double>(number));
    if (has_number(table, open_column)) open.push_back(static_cast<double>(number));
    // A theory that depends on the method is drawn in its colour, one for all once and in grey.
    for (std::size_t t = 0; t < map.theories.size(); ++t) {
      const std::string& name = map.theories[t].name;
      const bool common = is_common(solved, t), first = titled.insert(name).second;
      if (common && !first) continue;
      theories.push_back({table.name, first ? name : "", first_theory_column + static_cast<int>(t), common ? 0 : number,
                          t % 2 == 0 ? 7 : 8});
    }
  }
  DataTable here{id + "_here", {heading(map.x_label), heading(map.y_label)}, {}};
  for (const Boundary& b : beside.boundaries)
    if (b.kind == BoundaryKind::found) here.rows.push_back({b.x, b.y});
  if (!here.rows.empty()) output.data.push_back(write_csv(here, folder));
  for (const Map::Mark& mark : map.marks) y.include(mark.y);

  PlotValues values;
  set_axes(map, solved, y, values);
  values.files("series", tables);
  values.texts("series_title", titles);
  values.number("bracketed_end", static_cast<double>(bracketed.size()));
  values.number("open_end", static_cast<double>(open.size()));
  for (auto* list : {&bracketed, &open})
    if (list->empty()) list->push_back(1.0);  // gnuplot reads the first entry of an empty list
  values.numbers("bracketed", bracketed);
  values.numbers("open", open);
  values.files("here", here.rows.empty() ? std::vector<std::string>{} : std::vector{here.name});
  set_theories(theories, values);
  const std::size_t entries = tables.size() + titled.size() + (here.rows.empty() ? 0 : 1);
  values.number("key_rows", static_cast<double>((entries + 1) / 2));
  draw_plot(id, source_folder() / "experiments/numerics/stability/map.gp", values, {620, 500}, folder);
  return output;
}

}  // namespace slfb::stability

namespace slfb {

namespace {

/// Whoever draws the figure meets the error of a damaged file; the other figures and commands do not.
std::string title_of(const std::filesystem::path& file) {
  try {
    return stability::load_map(file, studies::Set::full).title;
  } catch (const std::exception&) {
    return file.filename().string() + " (cannot be read)";
  }
}

}  // namespace

std::vector<Figure> stability_maps() {
  std::vector<Figure> list;
  for (const auto& file : stability::map_files())
    list.push_back({"stability-" + file.stem().string(), title_of(file), no_runs,
                    [file](const FigureContext& context) {
                      const auto map = stability::load_map(file, studies::Set::full);
                      return stability::draw_map(map, stability::load_solved(map, context.results),
                                                 stability::load_beside(map, context.results), context.out);
                    },
                    "numerics/stability"});
  return list;
}

}  // namespace slfb
