#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/frontier/solved_study.hpp"
#include "experiments/numerics/stability/map.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::paper_steps {
namespace {

using frontier::ReducedPoint;
using frontier::SolvedStudy;

const std::vector<std::pair<std::string, std::string>> headings{{"", "setting of the paper"},
                                                                {"", "measured by"},
                                                                {"", "the paper"},
                                                                {"limit, or", "resolved"},
                                                                {"of the limit,", "or change"},
                                                                {"", ""}};

const FigureFolder folder{"peng_2014/paper_steps"};

FigureOutput draw(const FigureContext& context) {
  const auto file = source_folder() / "experiments/peng_2014/paper_steps/paper_steps.toml";
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
      setting =
          estimate_run(load_scene(source_folder() / "experiments/peng_2014/scenes/6in5W_paper-literal.toml", overrides))
              .steps_per_contact;
    } else {
      setting = one.number("setting");
    }
    one.reject_others();
    const auto map = stability::load_map(stability::map_file(id), studies::Set::full);
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
    const SolvedStudy solved = frontier::load_solved(id, context.results);
    const ReducedPoint* point = solved.at(series, axis);
    if (point == nullptr) {
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
      const auto error = solved.error_of(*point, quantity);
      if (reference == solved.reduced.reference.end() || !error) continue;
      const double change = point->values.at(quantity).value / reference->second.value - 1.0;
      rows.push_back({what, solved.title(quantity), fmt::format("{:.3g}", point->values.at(quantity).value),
                      fmt::format("{:.3g}", reference->second.value),
                      fmt::format("{:+.1f} ± {:.1f} %", 100.0 * change, 100.0 * error->half_width),
                      std::abs(change) > error->half_width ? "changed" : "not significant"});
      data.rows.push_back(
          {static_cast<double>(rows.size()), point->values.at(quantity).value, reference->second.value, change});
    }
    notes.push_back(fmt::format("{}: study {}, {}; {} set of {}.", what, id, solved.study.reference_text,
                                solved.reduced.set, solved.reduced.date));
  }
  table.reject_others();
  return draw_table("paper-steps", folder, {headings, std::move(rows)}, data, notes, 1110, context.out);
}

}  // namespace

Figure figure() { return {"paper-steps", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::paper_steps
