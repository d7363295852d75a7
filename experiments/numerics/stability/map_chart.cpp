#include "experiments/numerics/stability/map_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "experiments/numerics/figures.hpp"
#include "reports/gnuplot.hpp"

namespace slfb::stability {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#aa4499", "#8a6d00", "#56b4e9"};
constexpr std::array points{7, 5, 9, 13, 11, 15};

/// A label of an axis as a heading: with a unit.
std::string heading(const std::string& label) { return label.ends_with(']') ? label : label + " [-]"; }

std::string colour_of(std::size_t series) { return colours[series % colours.size()]; }

}  // namespace

FigureOutput draw_map(const Map& map, const SolvedMap& solved, const SolvedMap& beside,
                      const std::filesystem::path& folder) {
  const std::string id = "stability-" + map.id;
  FigureOutput output{id, {}, map.caption + " Fails: " + map.criterion_text + ".", {}};
  if (solved.boundaries.empty()) {
    output.notes.push_back(fmt::format("Not yet computed: slfb stability {}.", map.id));
    draw_figure(id,
                "set label 1 'not yet computed' at graph 0.5, 0.5 center\nset xrange [0:1]\nset yrange [0:1]\nunset "
                "tics\nplot NaN notitle\n",
                {600, 200}, folder);
    return output;
  }
  std::vector<std::string> columns{heading(map.x_label), heading(map.y_label), "bracket (low) [-]",
                                   "bracket (high) [-]", "no boundary up to [-]"};
  for (const Theory& theory : map.theories) columns.push_back(theory.name + " [-]");
  std::string elements;
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  std::vector<std::string> theory_elements;
  std::set<std::string> theory_drawn;
  for (std::size_t s = 0; s < map.series.size(); ++s) {
    DataTable table{fmt::format("{}_{}", id, s), columns, {}};
    for (const Boundary& b : solved.boundaries) {
      if (b.series != map.series[s].name) continue;
      const bool found = b.kind == BoundaryKind::found;
      std::vector<double> row{b.x, found ? b.y : nothing, found ? b.low : nothing, found ? b.high : nothing,
                              found ? nothing : b.y};
      for (const double value : b.theory) {
        row.push_back(value);
        if (value > 0.0) low = std::min(low, value), high = std::max(high, value);
      }
      low = std::min(low, b.y);
      high = std::max(high, b.y);
      table.rows.push_back(std::move(row));
    }
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, folder));
    const std::string colour = colour_of(s);
    // Nothing is asked of gnuplot for a column without a number: it would warn.
    const auto any = [&](std::size_t column) {
      return std::any_of(table.rows.begin(), table.rows.end(),
                         [&](const auto& row) { return std::isfinite(row[column - 1]); });
    };
    elements += elements.empty() ? "" : ", ";
    if (any(2))  // bars first: they would take the points' middle away
      elements += fmt::format(
          "'{}.csv' skip 1 using 1:2:3:4 with yerrorbars linecolor rgb '{}' linewidth 1.4 pointtype 0 notitle, ",
          table.name, colour);
    elements += fmt::format("{} with linespoints linecolor rgb '{}' linewidth 2 pointtype {} pointsize 0.8 title {}",
                            any(2) ? fmt::format("'{}.csv' skip 1 using 1:2", table.name) : "NaN", colour,
                            points[s % points.size()], gnuplot_text(map.series[s].name));
    if (any(5))
      elements += fmt::format(
          ", '{}.csv' skip 1 using 1:5:(0):($5 > {:.6g} ? 0.45*$5 : -0.35*$5) with vectors head filled linecolor rgb "
          "'{}' "
          "linewidth 2 notitle",
          table.name, std::sqrt(map.y_low * map.y_high), colour);
    // A theory that depends on the method is drawn in its colour, one for all once and in grey.
    for (std::size_t t = 0; t < map.theories.size(); ++t) {
      std::string key = map.theories[t].name;
      bool common = true;
      for (const Boundary& a : solved.boundaries)
        for (const Boundary& b : solved.boundaries)
          if (a.x == b.x && std::isfinite(a.theory[t]) && std::isfinite(b.theory[t]) &&
              std::abs(a.theory[t] / b.theory[t] - 1.0) > 1e-6)
            common = false;
      if (common && !theory_drawn.insert(key).second) continue;
      const bool titled = common || theory_drawn.insert(key).second;
      theory_elements.push_back(fmt::format(
          "'{}.csv' skip 1 using 1:{} with lines linecolor rgb '{}' linewidth 1.4 dashtype ({}) title {}", table.name,
          6 + t, common ? "#5b6470" : colour, t % 2 == 0 ? "8, 5" : "2, 4", titled ? gnuplot_text(key) : "''"));
    }
  }
  DataTable here{id + "_here", {columns[0], columns[1]}, {}};
  for (const Boundary& b : beside.boundaries)
    if (b.kind == BoundaryKind::found) here.rows.push_back({b.x, b.y});
  if (!here.rows.empty()) {
    output.data.push_back(write_csv(here, folder));
    elements += fmt::format(
        ", '{}.csv' skip 1 using 1:2 with points pointtype 6 pointsize 1.4 linecolor rgb '#000000' title 'quick set, "
        "this "
        "machine'",
        here.name);
  }
  for (const std::string& element : theory_elements) elements += ", " + element;
  for (const Map::Mark& mark : map.marks) {
    elements += fmt::format(
        ", '+' every ::0::0 using ({0}):({1}) with points pointtype 3 pointsize 1.4 linewidth 2 linecolor rgb "
        "'#000000' "
        "notitle",
        mark.x, mark.y);
    low = std::min(low, mark.y);
    high = std::max(high, mark.y);
  }
  std::string commands = "set logscale y\n";
  double left = map.x_values.front(), right = left;
  for (const Boundary& b : solved.boundaries) left = std::min(left, b.x), right = std::max(right, b.x);
  for (const Map::Mark& mark : map.marks) left = std::min(left, mark.x), right = std::max(right, mark.x);
  if (map.x_logarithmic) {
    commands += fmt::format("set logscale x\nset xrange [{:.6g}:{:.6g}]\n", left / 1.3, right * 1.3);
    if (right / left > 50.0) commands += "set format x '10^{%L}'\n";
  } else {
    const double margin = 0.05 * (right - left);
    commands += fmt::format("set xrange [{:.6g}:{:.6g}]\n", left - margin, right + margin);
  }
  if (high / low > 50.0)
    commands += "set format y '10^{%L}'\n";
  else if (low < 1e-3)
    commands += "set format y '%.0e'\n";
  const double bottom = low / 1.8, top = high * 1.8;
  const bool upward = map.fails_high;
  commands += fmt::format("set yrange [{:.6g}:{:.6g}]\nset xlabel {}\nset ylabel {}\n", bottom, top,
                          gnuplot_text(map.x_label), gnuplot_text(map.y_label));
  for (std::size_t m = 0; m < map.marks.size(); ++m)
    commands += fmt::format("set label {} {} at {:.6g}, {:.6g} {} font ',11' front\n", 200 + m,
                            gnuplot_text(map.marks[m].text), map.marks[m].x, map.marks[m].y,
                            map.marks[m].x > 0.7 * right ? "right offset -1, 0" : "offset 1, 0");
  commands += fmt::format("set label 300 'fails' at graph 0.985, graph {} right font ',12' textcolor rgb '#b0303c'\n",
                          upward ? 0.96 : 0.04);
  commands += fmt::format("set label 301 'holds' at graph 0.985, graph {} right font ',12' textcolor rgb '#3f7f5f'\n",
                          upward ? 0.04 : 0.96);
  const std::size_t rows = (map.series.size() + theory_elements.size() + (here.rows.empty() ? 0 : 1) + 1) / 2;
  commands += fmt::format(
      "set bmargin {}\nset key at graph 0.5, character {} center top vertical maxrows {} Left reverse font ',11' width "
      "2\n",
      5 + rows, static_cast<double>(rows) + 1.3, rows);
  draw_figure(id, commands + "plot " + elements + "\n", {620, 500}, folder);
  std::set<std::string> told;
  for (const Boundary& b : solved.boundaries) {
    if (b.kind == BoundaryKind::always_fails)
      output.notes.push_back(fmt::format("{} at {:g}: fails in the whole range ({}).", b.series, b.x, b.diagnosis));
    else if (b.kind == BoundaryKind::found && told.insert(b.series).second)
      output.notes.push_back(fmt::format("{}: beyond the boundary {}.", b.series, b.diagnosis));
  }
  output.notes.push_back(fmt::format("{} set of `slfb stability {}`, {}.", solved.set, map.id, solved.date));
  return output;
}

}  // namespace slfb::stability

namespace slfb {

std::vector<Figure> stability_maps() {
  std::vector<Figure> list;
  for (const auto& file : stability::map_files())
    list.push_back({"stability-" + file.stem().string(), stability::load_map(file, studies::Set::full).title, no_runs,
                    [file](const FigureContext& context) {
                      const auto map = stability::load_map(file, studies::Set::full);
                      return stability::draw_map(map, stability::load_solved(map, context.results),
                                                 stability::load_beside(map, context.results), context.out);
                    },
                    "numerics/stability"});
  return list;
}

}  // namespace slfb
