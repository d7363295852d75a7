#include <fmt/format.h>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/figures.hpp"
#include "experiments/numerics/frontier/solved_study.hpp"

namespace slfb {
namespace {

using frontier::percent;
using frontier::ReducedPoint;
using frontier::SolvedStudy;

const std::vector<std::pair<std::string, std::string>> headings{{"", "study"},
                                                                {"", "default, at"},
                                                                {"", "quantity"},
                                                                {"", "error"},
                                                                {"best of what", "is cheaper"},
                                                                {"cheapest of what", "is better"}};

const FigureFolder folder{"numerics/frontier/default_knees"};

/// "0.4 of the cost: 12 ± 3 %": the best of what is cheaper, or the cheapest of what is better.
std::string neighbour(const SolvedStudy& solved, const ReducedPoint& of, const std::string& quantity, bool cheaper) {
  const auto own = solved.error_of(of, quantity);
  if (!own) return "–";
  const ReducedPoint* best = nullptr;
  for (const ReducedPoint& point : solved.reduced.points) {
    const auto error = solved.error_of(point, quantity);
    if (!error) continue;
    if (cheaper ? !(point.cpu_seconds < of.cpu_seconds)
                : !(point.cpu_seconds > of.cpu_seconds && error->value < own->value))
      continue;
    if (best == nullptr ||
        (cheaper ? error->value < solved.error_of(*best, quantity)->value : point.cpu_seconds < best->cpu_seconds))
      best = &point;
  }
  return best == nullptr ? "none"
                         : fmt::format("{:.2g} of the cost: {}", best->cpu_seconds / of.cpu_seconds,
                                       percent(solved.error_of(*best, quantity)));
}

FigureOutput draw(const FigureContext& context) {
  DataTable data{
      "default-knees",
      {"row [-]", "CPU time of the default [s]", "its relative error [-]", "half width of the 95 % interval [-]"},
      {}};
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  for (const auto& file : frontier::study_files()) {
    const SolvedStudy solved = frontier::load_solved(file.stem().string(), context.results);
    if (solved.study.default_series.empty()) continue;
    const ReducedPoint* standard = solved.nearest(solved.study.default_series, solved.study.default_axis);
    notes.push_back(fmt::format("{}: {}", solved.study.id, solved.study.default_text));
    if (standard == nullptr) {
      rows.push_back({solved.study.id, "not yet computed", "", "", "", ""});
      continue;
    }
    bool first = true;
    for (const auto& quantity : solved.study.quantities) {
      const auto error = solved.error_of(*standard, quantity);
      if (!error) continue;
      rows.push_back({first ? solved.study.id : "",
                      first ? fmt::format("{}, {:g}", standard->series, standard->axis) : "", solved.title(quantity),
                      percent(error), neighbour(solved, *standard, quantity, true),
                      neighbour(solved, *standard, quantity, false)});
      data.rows.push_back({static_cast<double>(rows.size()), standard->cpu_seconds, error->value, error->half_width});
      first = false;
    }
  }
  return draw_table("default-knees", folder, {headings, std::move(rows)}, data, notes, 1184, context.out);
}

}  // namespace

Figure default_knees() { return {"default-knees", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb
