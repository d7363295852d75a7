#include "experiments/numerics/frontier/frontier_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/numerics/figures.hpp"
#include "reports/gnuplot.hpp"

namespace slfb::frontier {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#aa4499", "#8a6d00", "#56b4e9", "#5a4fa2", "#b0303c"};

std::string style_of(std::size_t series) {
  constexpr std::array points{7, 5, 9, 13, 11, 15, 6, 4};
  const std::size_t k = series % colours.size();
  return fmt::format("linecolor rgb '{}' linewidth 1.6 pointtype {} pointsize 0.75", colours[k], points[k]);
}

std::string bars_of(std::size_t series) {
  return fmt::format("linecolor rgb '{}' linewidth 1.2 pointtype 0", colours[series % colours.size()]);
}

/// A label of an axis as a heading: with a unit.
std::string heading(const std::string& label) { return label.ends_with(']') ? label : label + " [-]"; }

struct Reason {
  std::string text;
  int number;
};

/// A method that gave the quantity with an error that a logarithmic axis can show.
bool has_point(const ReducedPoint& point, const std::string& quantity) {
  const auto found = point.values.find(quantity);
  return point.failure.empty() && found != point.values.end() && found->second.error > 0.0 &&
         std::isfinite(found->second.error);
}

}  // namespace

FigureOutput draw_frontier(const Study& study, const ReducedStudy& reduced, const ReducedStudy& beside,
                           const std::filesystem::path& folder) {
  const std::string id = "frontier-" + study.id;
  FigureOutput output{id, {}, study.caption, {}};
  const studies::Problem& problem = studies::find_problem(study.problem);
  if (reduced.points.empty()) {
    output.notes.push_back(fmt::format("Not yet computed: slfb frontier {}.", study.id));
    draw_figure(id,
                "set label 1 'not yet computed' at graph 0.5, 0.5 center\nset xrange [0:1]\nset yrange [0:1]\nunset "
                "tics\nplot NaN notitle\n",
                {600, 200}, folder);
    return output;
  }
  // One table a method: what is drawn, and no more.
  std::vector<Reason> reasons;
  std::vector<std::string> columns{heading(study.axis_label), fmt::format("CPU time per {} [s]", problem.cost_unit),
                                   fmt::format("{} per {} [-]", study.count, problem.cost_unit), "replicates [-]",
                                   "number of the reason of failure [-]"};
  const std::size_t first_quantity = columns.size();
  std::vector<std::string> shown;
  for (const std::string& quantity : study.quantities)
    if (std::any_of(reduced.points.begin(), reduced.points.end(), [&](const ReducedPoint& p) {
          return p.values.contains(quantity) && std::isfinite(p.values.at(quantity).error);
        }))
      shown.push_back(quantity);
  for (const std::string& quantity : shown) {
    const auto& about = studies::find_quantity(problem, quantity);
    for (const char* what : {"", " (half width of the 95 % interval)"})
      columns.push_back(fmt::format("{}{} [{}]", about.title, what, about.unit));
    for (const char* what : {"relative error", "relative error (low)", "relative error (high)"})
      columns.push_back(fmt::format("{} of {} [-]", what, about.title));
  }
  std::vector<std::string> names;
  for (std::size_t s = 0; s < study.series.size(); ++s) {
    DataTable table{fmt::format("{}_{}", id, s), columns, {}};
    for (const ReducedPoint& point : reduced.points) {
      if (point.series != study.series[s]) continue;
      double reason = nothing;
      if (!point.failure.empty()) {
        auto known =
            std::find_if(reasons.begin(), reasons.end(), [&](const Reason& r) { return r.text == point.failure; });
        if (known == reasons.end())
          known = reasons.insert(known, {point.failure, static_cast<int>(reasons.size()) + 1});
        reason = known->number;
      }
      const auto count = point.counts.find(study.count);
      std::vector<double> row{point.axis, point.cpu_seconds, count == point.counts.end() ? nothing : count->second,
                              static_cast<double>(point.replicates), reason};
      for (const std::string& quantity : shown) {
        const auto found = point.values.find(quantity);
        const bool usable = point.failure.empty() && found != point.values.end() && found->second.error > 0.0;
        const PointValue value = usable ? found->second : PointValue{nothing, nothing, nothing, nothing};
        const double half = std::isfinite(value.error_half_width) ? value.error_half_width : 0.0;
        row.insert(row.end(), {value.value, value.half_width, value.error,
                               std::max(value.error - half, 0.1 * value.error), value.error + half});
      }
      table.rows.push_back(std::move(row));
    }
    names.push_back(table.name);
    output.data.push_back(write_csv(table, folder));
  }
  DataTable here{id + "_here", {columns[0], columns[1], columns[2]}, {}};
  for (const std::string& quantity : shown)
    here.columns.push_back(fmt::format("relative error of {} [-]", studies::find_quantity(problem, quantity).title));
  for (const ReducedPoint& point : beside.points) {
    const auto count = point.counts.find(study.count);
    std::vector<double> row{point.axis, point.cpu_seconds, count == point.counts.end() ? nothing : count->second};
    for (const std::string& quantity : shown)
      row.push_back(has_point(point, quantity) ? point.values.at(quantity).error : nothing);
    here.rows.push_back(std::move(row));
  }
  if (!here.rows.empty()) output.data.push_back(write_csv(here, folder));
  const bool both_costs = shown.size() <= 3;
  for (std::size_t q = 0; q < shown.size(); ++q)
    for (const bool by_count : both_costs ? std::vector{true, false} : std::vector{false}) {
      DataTable front{fmt::format("{}_front_{}{}", id, shown[q], by_count ? "_by_count" : ""),
                      {columns[by_count ? 2 : 1], "relative error [-]"},
                      {}};
      for (const ReducedPoint* point : pareto_front(reduced, shown[q], by_count ? study.count : ""))
        if (point->values.at(shown[q]).error > 0.0)
          front.rows.push_back(
              {by_count ? point->counts.at(study.count) : point->cpu_seconds, point->values.at(shown[q]).error});
      output.data.push_back(write_csv(front, folder));
    }

  const int key_rows = here.rows.empty() ? 2 : 3;
  const std::size_t columns_drawn = std::min<std::size_t>(shown.size() > 6 ? 4 : 3, shown.size());
  const std::size_t rows_drawn = both_costs ? 2 : (shown.size() + columns_drawn - 1) / columns_drawn;
  std::string plots;
  bool key_drawn = false;
  // What no machine changes above, the time of this machine below.
  for (const int cost : both_costs ? std::vector<int>{3, 2} : std::vector<int>{2})
    for (std::size_t q = 0; q < shown.size(); ++q) {
      const auto at = static_cast<int>(first_quantity + 5 * q) + 1;  // first column of the quantity
      plots += fmt::format("set title {} font ',13' offset 0,-0.8\nset xlabel {} font ',13'\n",
                           gnuplot_text(studies::find_quantity(problem, shown[q]).title),
                           gnuplot_text(cost == 2 ? fmt::format("CPU seconds per {}", problem.cost_unit)
                                                  : fmt::format("{} per {}", study.count, problem.cost_unit)));
      plots += q % columns_drawn == 0 ? "set ylabel 'relative error' font ',13' offset 2,0\n" : "unset ylabel\n";
      const auto reference = reduced.reference.find(shown[q]);
      const bool band = reference != reduced.reference.end() && reference->second.error_half_width > 0.0;
      if (band)
        plots += fmt::format(
            "set object 1 rectangle from graph 0, graph 0 to graph 1, first {:.6g} fillcolor rgb '#dfe3e8' fillstyle "
            "solid noborder behind\n",
            reference->second.error_half_width);
      std::string elements;
      for (std::size_t s = 0; s < names.size(); ++s) {
        // A series without a point keeps its place in the key.
        const bool drawn = std::any_of(reduced.points.begin(), reduced.points.end(), [&](const ReducedPoint& p) {
          return p.series == study.series[s] && has_point(p, shown[q]) && (cost == 2 || p.counts.contains(study.count));
        });
        const std::string title = key_drawn ? "''" : gnuplot_text(study.series[s]);
        elements += elements.empty() ? "" : ", ";
        if (drawn)  // bars first: they would take the points' middle away
          elements += fmt::format(
              "'{}.csv' skip 1 using {}:{}:{}:{} with yerrorbars {} notitle, '' skip 1 using {}:{} with linespoints {} "
              "title {}",
              names[s], cost, at + 2, at + 3, at + 4, bars_of(s), cost, at + 2, style_of(s), title);
        else
          elements += fmt::format("NaN with linespoints {} title {}", style_of(s), title);
        if (std::none_of(reduced.points.begin(), reduced.points.end(),
                         [&](const ReducedPoint& p) { return p.series == study.series[s] && !p.failure.empty(); }))
          continue;
        // A failure has a cost but no error: a numbered cross at the top of the chart.
        elements += fmt::format(
            ", '{2}.csv' skip 1 using (${0} > 0 ? ${1} : NaN):(top) with points pointtype 2 pointsize 1.1 linewidth 2 "
            "linecolor rgb '#b0303c' notitle, '' skip 1 using (${0} > 0 ? ${1} : NaN):(top):(sprintf('%d', ${0})) with "
            "labels "
            "offset 0.9, 0 font ',10' textcolor rgb '#b0303c' notitle",
            5, cost, names[s]);
      }
      const auto front = pareto_front(reduced, shown[q], cost == 2 ? "" : study.count);
      if (std::any_of(front.begin(), front.end(), [&](const ReducedPoint* p) { return has_point(*p, shown[q]); }))
        elements += fmt::format(
            ", '{}_front_{}{}.csv' skip 1 using 1:2 with fsteps linecolor rgb '#000000' linewidth 1 dashtype (6, 4) "
            "title {}",
            id, shown[q], cost == 2 ? "" : "_by_count", key_drawn ? "''" : "'Pareto front'");
      const auto cost_column = static_cast<std::size_t>(cost) - 1;
      if (std::any_of(here.rows.begin(), here.rows.end(),
                      [&](const auto& row) { return std::isfinite(row[cost_column]) && std::isfinite(row[3 + q]); }))
        elements += fmt::format(
            ", '{}.csv' skip 1 using {}:{} with points pointtype 6 pointsize 1.4 linecolor rgb '#000000' title {}",
            here.name, cost, 4 + q, key_drawn ? "''" : "'quick set, this machine'");
      // The range first, so that the marks of failures can be put at its top.
      double low = std::numeric_limits<double>::infinity(), high = 0.0;
      for (const auto& row : here.rows)
        if (std::isfinite(row[3 + q])) low = std::min(low, row[3 + q]), high = std::max(high, row[3 + q]);
      for (const ReducedPoint& point : reduced.points) {
        const auto found = point.values.find(shown[q]);
        if (!point.failure.empty() || found == point.values.end() || !(found->second.error > 0.0)) continue;
        low = std::min(low, found->second.error);
        high = std::max(high, found->second.error);
      }
      low = std::max(low, 1e-12);
      // Points of one cost leave gnuplot without a range of its own.
      double least = std::numeric_limits<double>::infinity(), most = 0.0;
      for (const ReducedPoint& point : reduced.points) {
        const auto count = point.counts.find(study.count);
        const double value = cost == 2 ? point.cpu_seconds : count == point.counts.end() ? nothing : count->second;
        least = std::fmin(least, value);
        most = std::fmax(most, value);
      }
      plots += most < 1.01 * least ? fmt::format("set xrange [{:.6g}:{:.6g}]\n", 0.5 * least, 2.0 * most)
                                   : std::string("set xrange [*:*]\n");
      plots += fmt::format("top = {:.6g}\nset yrange [{:.6g}:{:.6g}]\n", 5.0 * high, 0.4 * low, 9.0 * high);
      if (!key_drawn)
        plots +=
            fmt::format("set key at screen 0.5, 0.985 center top vertical maxrows {} width 2 font ',12'\n", key_rows);
      plots += fmt::format("plot {}\nunset object 1\nset key off\n", elements);
      key_drawn = true;
    }

  std::vector<std::string> lines;
  if (!study.reference_text.empty()) lines.push_back("Errors: " + study.reference_text);
  lines.push_back(fmt::format("{} set, {}, {}.", reduced.set, reduced.machine, reduced.date));
  for (const Reason& reason : reasons) lines.push_back(fmt::format("x {}  failed: {}", reason.number, reason.text));
  const int width = columns_drawn == 1 ? 620 : 330 * static_cast<int>(columns_drawn) + 60;
  const std::size_t longest = static_cast<std::size_t>(width) / 6;
  for (std::string& line : lines)
    if (line.size() > longest) line = line.substr(0, longest - 3) + "...";
  const int head = 32 + 17 * key_rows, foot = 16 * static_cast<int>(lines.size()) + 10;
  const int height = 290 * static_cast<int>(rows_drawn) + head + foot;
  std::string commands = fmt::format("set logscale xy\nset format '10^{{%L}}'\nset tics font ',11'\n");
  for (std::size_t k = 0; k < lines.size(); ++k)
    commands +=
        fmt::format("set label {} {} at screen 0.012, {:.5f} font ',10' textcolor rgb '#6b7580' front\n", 901 + k,
                    gnuplot_text(lines[k]), (foot - 4.0 - 16.0 * (static_cast<double>(k) + 0.5)) / height);
  commands +=
      fmt::format("set multiplot layout {},{} margins {:.4f},0.97,{:.4f},{:.4f} spacing 0.075,{:.4f}\n", rows_drawn,
                  columns_drawn, 78.0 / width, (foot + 68.0) / height, 1.0 - (head + 20.0) / height, 108.0 / height);
  // The text below belongs to the page, not to each of its plots.
  const std::string clear = fmt::format("unset for [tag=901:{}] label tag\n", 900 + lines.size());
  const auto after_first = plots.find("unset object 1\n");
  plots.insert(after_first, clear);
  draw_figure(id, commands + plots + "unset multiplot\n", {width, height}, folder);
  output.notes.push_back(
      fmt::format("{} set of `slfb frontier {}`, {}, {}.", reduced.set, study.id, reduced.machine, reduced.date));
  if (!here.rows.empty())
    output.notes.push_back(
        fmt::format("Circles: quick set, {}, {}; against its own reference.", beside.machine, beside.date));
  for (const Reason& reason : reasons)
    output.notes.push_back(fmt::format("Failed (x {}): {}", reason.number, reason.text));
  if (!study.default_text.empty()) output.notes.push_back("The suite's default: " + study.default_text);
  return output;
}

}  // namespace slfb::frontier

namespace slfb {

std::vector<Figure> frontier_charts() {
  std::vector<Figure> list;
  for (const auto& file : frontier::study_files())
    list.push_back({"frontier-" + file.stem().string(), frontier::load_study(file, studies::Set::full).title, no_runs,
                    [file](const FigureContext& context) {
                      const auto study = frontier::load_study(file, studies::Set::full);
                      return frontier::draw_frontier(study, frontier::load_reduced(study, context.results),
                                                     frontier::load_beside(study, context.results), context.out);
                    },
                    "numerics/frontier"});
  return list;
}

}  // namespace slfb
