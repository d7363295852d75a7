#include "experiments/numerics/plan/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "experiments/numerics/frontier/study.hpp"
#include "experiments/quantities/analysis.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::plan {
namespace {

Rule::Condition condition_of(TomlTable& table, const std::string& text) {
  std::istringstream words(text);
  std::string number, comparison;
  double value = 0.0;
  if (!(words >> number >> comparison >> value) || (comparison != "<" && comparison != ">"))
    throw table.problem("when", fmt::format("\"{}\" must read NUMBER > VALUE or NUMBER < VALUE", text));
  return {number, comparison == ">", value};
}

/// What a study says of a choice.
struct Measured {
  double error;           ///< relative, without what chance adds to it [-]
  double standard_error;  ///< of the deviation behind it [-]
};

/// Standard error of a mean of replicates, from its 95 % interval; 0 where there is none.
double error_of_mean(double half_width, int replicates) {
  return replicates > 1 && half_width > 0.0 ? standard_error(half_width, static_cast<std::size_t>(replicates)) : 0.0;
}

std::string text_of(const frontier::ReducedPoint& point) { return fmt::format("{} at {:g}", point.series, point.axis); }

/// The point of a study that `table` names by `series` and `axis`.
const frontier::ReducedPoint& point_of(TomlTable& table, const frontier::ReducedStudy& solved) {
  const std::string series = table.text("series");
  const double axis = table.number("axis");
  for (const frontier::ReducedPoint& point : solved.points)
    if (point.series == series && std::abs(point.axis - axis) <= 1e-9 * std::abs(axis) && !point.values.empty())
      return point;
  throw table.problem("axis", fmt::format("the committed set of study \"{}\" has no answer of \"{}\" at {:g}",
                                          solved.id, series, axis));
}

/// Adds to `measured`, by quantity, the deviation of a point of a committed study from the study's reference, or from
/// another point of it; of several measurements the one with the smallest standard error wins. Chance adds the square
/// of its standard error to the mean square of a deviation: that is subtracted.
/// \return study, points, set and date, for the evidence of the rule
std::string add_measured(TomlTable& table, std::map<std::string, Measured>& measured) {
  const frontier::ReducedStudy solved = frontier::load_committed(table.text("study"));
  const frontier::ReducedPoint& point = point_of(table, solved);
  const frontier::ReducedPoint* against = nullptr;
  if (table.has("against")) {
    TomlTable other = table.table("against");
    against = &point_of(other, solved);
    other.reject_others();
  }
  table.reject_others();
  const auto& others = against == nullptr ? solved.reference : against->values;
  for (const auto& [quantity, value] : point.values) {
    Measured found{value.error, 0.0};
    if (const auto other = others.find(quantity); other != others.end()) {
      const double truth = other->second.value;
      found.standard_error = std::hypot(error_of_mean(value.half_width, point.replicates),
                                        error_of_mean(other->second.half_width, point.replicates)) /
                             std::abs(truth);
      const double deviation = value.value / truth - 1.0;
      found.error = std::sqrt(std::max(0.0, deviation * deviation - found.standard_error * found.standard_error));
    }
    const auto [entry, added] = measured.try_emplace(quantity, found);
    if (!added && found.standard_error < entry->second.standard_error) entry->second = found;
  }
  return fmt::format("frontier {} ({}{}; {} set of {})", solved.id, text_of(point),
                     against == nullptr ? "" : " against " + text_of(*against), solved.set, solved.date);
}

}  // namespace

Rules load_rules() { return load_rules(source_folder() / "experiments" / "numerics" / "plan" / "rules.toml"); }

Rules load_rules(const std::filesystem::path& file) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  Rules rules;
  rules.forces = table.texts("forces");
  const toml::table* bands = parsed["bands"].as_table();
  if (bands == nullptr) throw table.problem("bands", "is missing");
  for (const auto& [quantity, band] : *bands) rules.bands[std::string(quantity.str())] = band.value_or(0.0);
  for (TomlTable& one : table.tables("rule")) {
    Rule rule;
    rule.subject = one.text("subject");
    rule.choice = one.text("choice");
    rule.why = one.text("why");
    rule.source = one.text("source");
    rule.evidence = one.text("evidence", "");
    rule.richer = one.text("richer", "");
    for (const std::string& text : one.texts("when")) rule.when.push_back(condition_of(one, text));
    rule.asked = one.texts("asked");
    rule.only = one.texts("only");
    rule.set = one.texts("set");
    rule.richer_set = one.texts("richer_set");
    rule.steps_per_contact = one.number("steps_per_contact", 0.0);
    rule.liquid_steps_per_relaxation = one.number("liquid_steps_per_relaxation", 0.0);
    if (rule.liquid_steps_per_relaxation > 0.0) rule.longest_liquid_step = one.number("longest_liquid_step");
    rule.effect = one.numbers_by_name("effect");
    for (const auto& [quantity, error] : rule.effect)
      if (!rules.bands.contains(quantity)) throw one.problem("effect", quantity + " has no band");
    std::map<std::string, Measured> measured;
    for (TomlTable& point : one.tables("measured"))
      rule.evidence += (rule.evidence.empty() ? "" : "; ") + add_measured(point, measured);
    for (const auto& [quantity, found] : measured)
      if (rules.bands.contains(quantity)) rule.effect.try_emplace(quantity, found.error);
    if (rule.evidence.empty()) throw one.problem("evidence", "is missing, and so is measured");
    one.reject_others();
    rules.list.push_back(std::move(rule));
  }
  return rules;
}

}  // namespace slfb::plan
