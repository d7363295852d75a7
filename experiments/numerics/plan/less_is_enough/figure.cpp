#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/figures.hpp"
#include "experiments/numerics/frontier/solved_study.hpp"
#include "experiments/numerics/plan/plan.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

using frontier::percent;
using frontier::ReducedPoint;
using frontier::SolvedStudy;

const std::vector<std::pair<std::string, std::string>> headings{{"", "asked"}, {"", "answered by"}, {"", "error"},
                                                                {"", "band"},  {"", "CPU"},         {"", "verdict"}};

const FigureFolder folder{"numerics/plan/less_is_enough"};

FigureOutput draw(const FigureContext& context) {
  const auto file = source_folder() / "experiments/numerics/plan/less_is_enough/examples.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  const auto bands = plan::load_rules().bands;
  DataTable data{"less-is-enough",
                 {"row [-]", "relative error [-]", "half width of the 95 % interval [-]", "band [-]", "CPU time [s]"},
                 {}};
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  for (TomlTable& one : table.tables("example")) {
    const std::string with = one.text("with"), id = one.text("study"), series = one.text("series"),
                      quantity = one.text("quantity");
    const double axis = one.number("axis");
    if (!bands.contains(quantity)) throw one.problem("quantity", "has no band in rules.toml");
    one.reject_others();
    const SolvedStudy solved = frontier::load_solved(id, context.results);
    std::string note = fmt::format("Study {}: {} set, {}.", id, solved.reduced.set, solved.reduced.date);
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
    const double band = bands.at(quantity);
    const ReducedPoint* point = solved.nearest(series, axis);
    const auto error = point == nullptr ? std::nullopt : solved.error_of(*point, quantity);
    const std::string title = solved.title(quantity);
    if (!error) {
      rows.push_back({title, with, "not yet computed", fmt::format("{:.2g} %", 100.0 * band), "", ""});
      continue;
    }
    const char* verdict = error->value + error->half_width <= band            ? "enough"
                          : error->value - error->half_width > band           ? "not enough"
                          : error->value <= band && error->half_width <= band ? "enough, not significant"
                                                                              : "not decided";
    rows.push_back({title, with, percent(error), fmt::format("{:.2g} %", 100.0 * band),
                    fmt::format("{:.2g} s", point->cpu_seconds), verdict});
    data.rows.push_back({static_cast<double>(rows.size()), error->value, error->half_width, band, point->cpu_seconds});
  }
  table.reject_others();
  return draw_table("less-is-enough", folder, {headings, std::move(rows)}, data, notes, 1090, context.out);
}

}  // namespace

Figure less_is_enough() { return {"less-is-enough", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb
