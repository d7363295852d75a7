#include "experiments/work/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/work/report_pages.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

std::string with_unit_of(const std::string& number, const Claim& claim) {
  return claim.unit == "-" ? number : number + " " + claim.unit;
}

std::string ours_text(const Evaluation& evaluation) {
  if (!evaluation.ours) return "–";
  std::string number = fmt::format("{:.3g}", *evaluation.ours);
  if (evaluation.interval && evaluation.interval->second > evaluation.interval->first) {
    const double half_width = 0.5 * (evaluation.interval->second - evaluation.interval->first);
    number += fmt::format(" ± {:.6g}", std::stod(fmt::format("{:.2g}", half_width)));  // "81", not "8.1e+01"
  }
  return with_unit_of(number, evaluation.claim);
}

std::string paper_text(const Claim& claim) {
  return with_unit_of(claim.kind == StatementKind::value ? fmt::format("{:.4g}", claim.paper) : claim.paper_text(),
                      claim);
}

const Evaluation* evaluation_of(const std::vector<Evaluation>& evaluations, const std::string& id) {
  const auto found = std::ranges::find(evaluations, id, [](const Evaluation& one) { return one.claim.id; });
  return found == evaluations.end() ? nullptr : &*found;
}

/// `text` with its numbers.
std::string filled_in(TomlTable& table, const std::vector<Evaluation>& evaluations) {
  std::string text = table.text("text");
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open)) {
    const std::size_t colon = text.find(':', open), close = text.find('}', open);
    const std::string which = text.substr(open + 1, std::min(colon, close) - open - 1);
    if (close == std::string::npos || colon > close || (which != "ours" && which != "paper"))
      throw table.problem("text", "what stands in braces is {ours:CLAIM} or {paper:CLAIM}");
    const std::string id = text.substr(colon + 1, close - colon - 1);
    const Evaluation* evaluation = evaluation_of(evaluations, id);
    if (evaluation == nullptr) throw table.problem("text", fmt::format("there is no claim \"{}\"", id));
    const std::string number = which == "ours" ? ours_text(*evaluation) : paper_text(evaluation->claim);
    text.replace(open, close - open + 1, number);
    open += number.size();
  }
  return text;
}

}  // namespace

std::vector<reports::FindingRow> findings(const Work& work, const std::vector<Evaluation>& evaluations) {
  const auto file = work.folders.reference_data / "findings.toml";
  std::vector<reports::FindingRow> rows;
  if (!std::filesystem::exists(file)) return rows;
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  for (TomlTable& one : table.tables("finding")) {
    reports::FindingRow row{filled_in(one, evaluations), one.text("figure"), {}};
    if (std::ranges::find(work.figures, row.figure, &Figure::id) == work.figures.end())
      throw one.problem("figure", fmt::format("there is no figure \"{}\"", row.figure));
    for (const auto& [key, stated] :
         {std::pair{"reproduced", Verdict::reproduced}, std::pair{"not_reproduced", Verdict::not_reproduced},
          std::pair{"not_decidable", Verdict::not_decidable}})
      for (const std::string& id : one.texts(key)) {
        const Evaluation* evaluation = evaluation_of(evaluations, id);
        if (evaluation == nullptr) throw one.problem(key, fmt::format("there is no claim \"{}\"", id));
        row.claims.push_back({id, shown(stated), shown(evaluation->verdict)});
      }
    if (row.claims.empty()) throw one.problem("text", "no claim carries it: list some under reproduced, …");
    one.reject_others();
    rows.push_back(std::move(row));
  }
  table.reject_others();
  return rows;
}

}  // namespace slfb
