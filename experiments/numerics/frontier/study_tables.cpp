#include "experiments/numerics/frontier/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/numerics/frontier/study.hpp"
#include "experiments/numerics/plan/plan.hpp"
#include "experiments/numerics/stability/map.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;
using frontier::PointValue;
using frontier::ReducedPoint;
using frontier::ReducedStudy;
using frontier::Study;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

fs::path experiments() { return source_folder() / "experiments"; }

struct SolvedStudy {
  Study study;
  ReducedStudy reduced;

  [[nodiscard]] std::string title(const std::string& quantity) const {
    return studies::find_quantity(studies::find_problem(study.problem), quantity).title;
  }
  /// The point of a series nearest to `axis`, on a logarithmic scale; null when nothing of the series was computed.
  [[nodiscard]] const ReducedPoint* nearest(const std::string& series, double axis) const {
    const auto distance = [&](const ReducedPoint& point) {
      return point.axis > 0.0 && axis > 0.0 ? std::abs(std::log(point.axis / axis)) : std::abs(point.axis - axis);
    };
    const ReducedPoint* best = nullptr;
    for (const ReducedPoint& point : reduced.points)
      if (point.series == series && (best == nullptr || distance(point) < distance(*best))) best = &point;
    return best;
  }
};

SolvedStudy solved_study(const std::string& id, const fs::path& results) {
  Study study =
      frontier::load_study(experiments() / "numerics" / "frontier" / "studies" / (id + ".toml"), frontier::Set::full);
  ReducedStudy reduced = frontier::load_reduced(study, results);
  return {std::move(study), std::move(reduced)};
}

/// Error of a point and the half width of its interval, that of the reference included; none where it has no answer.
std::optional<std::pair<double, double>> error_of(const SolvedStudy& solved, const ReducedPoint& point,
                                                  const std::string& quantity) {
  const auto found = point.values.find(quantity);
  if (!point.failure.empty() || found == point.values.end() || !std::isfinite(found->second.error)) return std::nullopt;
  const auto reference = solved.reduced.reference.find(quantity);
  const auto finite = [](double value) { return std::isfinite(value) ? value : 0.0; };
  return std::pair(
      found->second.error,
      std::hypot(finite(found->second.error_half_width),
                 reference == solved.reduced.reference.end() ? 0.0 : finite(reference->second.error_half_width)));
}

std::string percent(const std::optional<std::pair<double, double>>& error) {
  if (!error) return "–";
  const auto digits = [](double share) {
    return share < 0.995 ? fmt::format("{:.2g}", 100.0 * share) : fmt::format("{:.0f}", 100.0 * share);
  };
  return error->second > 0.0 ? fmt::format("{} ± {} %", digits(error->first), digits(error->second))
                             : fmt::format("{} %", digits(error->first));
}

FigureOutput drawn(const std::string& id, std::string caption, const std::vector<TableColumn>& columns,
                   const std::vector<std::vector<std::string>>& rows, const DataTable& data,
                   std::vector<std::string> notes, int width, const fs::path& folder) {
  draw_figure(id, table_commands(columns, rows, width), {width, table_height(rows.size())}, folder);
  return {id, {write_csv(data, folder)}, std::move(caption), std::move(notes)};
}

// --- knees of the defaults
// ---------------------------------------------------------------------------------------------

/// "0.4 of the cost: 12 ± 3 %": the best of what is cheaper, or the cheapest of what is better.
std::string neighbour(const SolvedStudy& solved, const ReducedPoint& of, const std::string& quantity, bool cheaper) {
  const auto own = error_of(solved, of, quantity);
  if (!own) return "–";
  const ReducedPoint* best = nullptr;
  for (const ReducedPoint& point : solved.reduced.points) {
    const auto error = error_of(solved, point, quantity);
    if (!error) continue;
    if (cheaper ? !(point.cpu_seconds < of.cpu_seconds)
                : !(point.cpu_seconds > of.cpu_seconds && error->first < own->first))
      continue;
    if (best == nullptr ||
        (cheaper ? error->first < error_of(solved, *best, quantity)->first : point.cpu_seconds < best->cpu_seconds))
      best = &point;
  }
  return best == nullptr ? "none"
                         : fmt::format("{:.2g} of the cost: {}", best->cpu_seconds / of.cpu_seconds,
                                       percent(error_of(solved, *best, quantity)));
}

FigureOutput draw_knees(const FigureContext& context) {
  DataTable data{
      "default-knees",
      {"row [-]", "CPU time of the default [s]", "its relative error [-]", "half width of the 95 % interval [-]"},
      {}};
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  for (const auto& file : frontier::study_files()) {
    const SolvedStudy solved = solved_study(file.stem().string(), context.results);
    if (solved.study.default_series.empty()) continue;
    const ReducedPoint* standard = solved.nearest(solved.study.default_series, solved.study.default_axis);
    notes.push_back(fmt::format("{}: {}", solved.study.id, solved.study.default_text));
    if (standard == nullptr) {
      rows.push_back({solved.study.id, "not yet computed", "", "", "", ""});
      continue;
    }
    bool first = true;
    for (const auto& quantity : solved.study.quantities) {
      const auto error = error_of(solved, *standard, quantity);
      if (!error) continue;
      rows.push_back({first ? solved.study.id : "",
                      first ? fmt::format("{}, {:g}", standard->series, standard->axis) : "", solved.title(quantity),
                      percent(error), neighbour(solved, *standard, quantity, true),
                      neighbour(solved, *standard, quantity, false)});
      data.rows.push_back({static_cast<double>(rows.size()), standard->cpu_seconds, error->first, error->second});
      first = false;
    }
  }
  return drawn("default-knees",
               "The point of each study nearest to the suite's default: its error, the least error of whatever is "
               "cheaper, and the cheapest that is better. A default sits on a knee where what is cheaper is much worse "
               "and what is better hardly so, or costs much. Where the interval is wider than the error, the error is "
               "not told from zero. The notes say why each default was taken.",
               {{"\nstudy", 14, true},
                {"\ndefault, at", 170, true},
                {"\nquantity", 400, true},
                {"\nerror", 700, false, "ours"},
                {"best of what\nis cheaper", 940},
                {"cheapest of what\nis better", 1170}},
               rows, data, notes, 1184, context.out);
}

// --- what follows for the paper
// ------------------------------------------------------------------------------------------

FigureOutput draw_paper_steps(const FigureContext& context) {
  const auto file = experiments() / "peng_2014" / "stability_of_the_paper.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  DataTable data{
      "paper-steps", {"row [-]", "the paper's [SI]", "limit or resolved value [SI]", "ratio less one [-]"}, {}};
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  for (TomlTable& one : table.tables("limit")) {
    const std::string what = one.text("what"), id = one.text("map"), series = one.text("series");
    const double x = one.number("x");
    // Given, or the steps in a contact of the bed's spheres that the paper's scene has.
    double setting = 0.0;
    if (one.has("steps_per_contact_with")) {
      auto overrides = one.texts("steps_per_contact_with");
      overrides.emplace_back("contact.allow_large_time_step=true");
      setting = estimate_run(load_scene(experiments() / "peng_2014" / "scenes" / "6in5W_paper-literal.toml", overrides))
                    .steps_per_contact;
    } else {
      setting = one.number("setting");
    }
    one.reject_others();
    const auto map =
        stability::load_map(experiments() / "numerics" / "stability" / "maps" / (id + ".toml"), stability::Set::full);
    const auto solved = stability::load_solved(map, context.results);
    const auto found = std::ranges::find_if(solved.boundaries, [&](const stability::Boundary& b) {
      return b.series == series && std::abs(b.x - x) < 1e-9 * std::abs(x);
    });
    if (found == solved.boundaries.end()) {
      rows.push_back({what, map.y_label, fmt::format("{:.3g}", setting), "not yet computed", "", ""});
      continue;
    }
    const bool inside = found->kind == stability::BoundaryKind::never_fails ||
                        (found->kind == stability::BoundaryKind::found &&
                         (map.fails_high ? setting < found->low : setting > found->high));
    const bool beyond = found->kind == stability::BoundaryKind::always_fails ||
                        (found->kind == stability::BoundaryKind::found &&
                         (map.fails_high ? setting > found->high : setting < found->low));
    rows.push_back(
        {what, map.y_label, fmt::format("{:.3g}", setting),
         found->kind == stability::BoundaryKind::found ? fmt::format("{:.3g}", found->y) : "none in the range",
         found->kind == stability::BoundaryKind::found ? fmt::format("{:.2f} of it", setting / found->y) : "",
         inside   ? "stands"
         : beyond ? "beyond the limit"
                  : "at the limit"});
    data.rows.push_back({static_cast<double>(rows.size()), setting, found->y, setting / found->y - 1.0});
    notes.push_back(fmt::format("{}: fails where {}; map {}, {} set of {}.", what, map.criterion_text, id, solved.set,
                                solved.date));
  }
  for (TomlTable& one : table.tables("change")) {
    const std::string what = one.text("what"), id = one.text("study"), series = one.text("series");
    const double axis = one.number("axis");
    const auto quantities = one.texts("quantities");
    one.reject_others();
    const SolvedStudy solved = solved_study(id, context.results);
    const ReducedPoint* point = solved.nearest(series, axis);
    if (point == nullptr || std::abs(point->axis - axis) > 1e-9 * axis) {
      rows.push_back({what, "", "", "not yet computed", "", ""});
      continue;
    }
    if (!point->failure.empty()) {
      rows.push_back({what, "", "failed", "", "", "does not run"});
      notes.push_back(fmt::format("{}: {}.", what, point->failure));
      continue;
    }
    for (const auto& quantity : quantities) {
      const auto reference = solved.reduced.reference.find(quantity);
      const auto error = error_of(solved, *point, quantity);
      if (reference == solved.reduced.reference.end() || !error) continue;
      const double change = point->values.at(quantity).value / reference->second.value - 1.0;
      rows.push_back({what, solved.title(quantity), fmt::format("{:.3g}", point->values.at(quantity).value),
                      fmt::format("{:.3g}", reference->second.value),
                      fmt::format("{:+.1f} ± {:.1f} %", 100.0 * change, 100.0 * error->second),
                      std::abs(change) > error->second ? "changed" : "no change told"});
      data.rows.push_back(
          {static_cast<double>(rows.size()), point->values.at(quantity).value, reference->second.value, change});
    }
    notes.push_back(fmt::format("{}: study {}, {}; {} set of {}.", what, id, solved.study.reference_text,
                                solved.reduced.set, solved.reduced.date));
  }
  table.reject_others();
  return drawn(
      "paper-steps",
      "Which settings of the paper stand beyond a limit of the stability maps, and what its contact step changes "
      "against a resolved one in slices of its bed. Every number is read from the published maps and studies; a "
      "change smaller than its 95 % interval is not told from none.",
      {{"\nsetting of the paper", 14, true},
       {"\nmeasured by", 330, true},
       {"\nthe paper", 640},
       {"limit, or\nresolved", 790},
       {"of the limit,\nor change", 950, false, "ours"},
       {"\n", 970, true}},
      rows, data, notes, 1110, context.out);
}

// --- where less is enough
// ------------------------------------------------------------------------------------------------

FigureOutput draw_examples(const FigureContext& context) {
  const auto file = experiments() / "numerics" / "plan" / "examples.toml";
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
    const SolvedStudy solved = solved_study(id, context.results);
    std::string note = fmt::format("Study {}: {} set, {}.", id, solved.reduced.set, solved.reduced.date);
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
    const double band = bands.at(quantity);
    const ReducedPoint* point = solved.nearest(series, axis);
    const auto error = point == nullptr ? std::nullopt : error_of(solved, *point, quantity);
    const std::string title = solved.title(quantity);
    if (!error) {
      rows.push_back({title, with, "not yet computed", fmt::format("{:.2g} %", 100.0 * band), "", ""});
      continue;
    }
    const char* verdict = error->first + error->second <= band            ? "enough"
                          : error->first - error->second > band           ? "not enough"
                          : error->first <= band && error->second <= band ? "enough, as far as told"
                                                                          : "not decided";
    rows.push_back({title, with, percent(error), fmt::format("{:.2g} %", 100.0 * band),
                    fmt::format("{:.2g} s", point->cpu_seconds), verdict});
    data.rows.push_back({static_cast<double>(rows.size()), error->first, error->second, band, point->cpu_seconds});
  }
  table.reject_others();
  return drawn(
      "less-is-enough",
      "Cheap answers beside their bands (`experiments/numerics/plan/rules.toml`): errors and costs are those of the "
      "studies of `slfb frontier`, the cost per simulated second, or per answer where nothing is simulated. "
      "Enough: error and interval lie inside the band; not enough: both beyond it.",
      {{"\nasked", 14, true},
       {"\nanswered by", 250, true},
       {"\nerror", 720, false, "ours"},
       {"\nband", 790},
       {"\nCPU", 890},
       {"\n", 910, true}},
      rows, data, notes, 1090, context.out);
}

std::vector<std::string> no_runs(const Profile&) { return {}; }

}  // namespace

std::vector<Figure> study_tables() {
  return {
      {"default-knees", "The knee that each default of the suite sits on", no_runs, draw_knees, "numerics/frontier"},
      {"paper-steps", "What follows for the paper: its steps and their limits", no_runs, draw_paper_steps,
       "numerics/stability"},
      {"less-is-enough", "Where less model is enough, and where it is not", no_runs, draw_examples, "numerics/plan"}};
}

}  // namespace slfb
