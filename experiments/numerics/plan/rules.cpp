#include "experiments/numerics/plan/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "experiments/numerics/frontier/study.hpp"
#include "experiments/numerics/plan/plan.hpp"
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

/// The first trial of the point, or of the reference where there is no such point.
const studies::Trial* trial_of(const frontier::Study& study, const frontier::ReducedPoint* point) {
  if (point == nullptr) return study.reference.empty() ? nullptr : &study.reference.front();
  for (const frontier::StudyPoint& one : study.points)
    if (one.series == point->series && std::abs(one.axis - point->axis) <= 1e-9 * std::abs(point->axis) &&
        !one.trials.empty())
      return &one.trials.front();
  return nullptr;
}

/// Widens what is covered by the numbers of the scenes that a study compared.
void add_covered(const frontier::ReducedPoint& point, const frontier::ReducedPoint* against,
                 const std::string& study_id, const std::map<std::string, double>& reach,
                 std::map<std::string, Range>& covered) {
  const frontier::Study study = frontier::load_study(frontier::study_file(study_id), studies::Set::full);
  for (const studies::Trial* trial : {trial_of(study, &point), trial_of(study, against)}) {
    if (trial == nullptr) continue;
    for (const Number& number : numbers_of(trial->scene())) {
      if (!reach.contains(number.name) || !(number.value > 0.0)) continue;
      Range& range = covered.try_emplace(number.name, Range{number.value, number.value}).first->second;
      range = {std::min(range.lowest, number.value), std::max(range.highest, number.value)};
    }
  }
}

/// Adds to `measured`, by quantity, the deviation of a point of a committed study from the study's reference, or from
/// another point of it; of several measurements the one with the smallest standard error wins. Chance adds the square
/// of its standard error to the mean square of a deviation: that is subtracted.
/// \return study, points, set and date, for the evidence of the rule
std::string add_measured(TomlTable& table, const std::map<std::string, double>& reach,
                         std::map<std::string, Measured>& measured, std::map<std::string, Range>& covered) {
  const frontier::ReducedStudy solved = frontier::load_committed(table.text("study"));
  const frontier::ReducedPoint& point = point_of(table, solved);
  const frontier::ReducedPoint* against = nullptr;
  if (table.has("against")) {
    TomlTable other = table.table("against");
    against = &point_of(other, solved);
    other.reject_others();
  }
  table.reject_others();
  add_covered(point, against, solved.id, reach, covered);
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

/// Standard deviation of one replicate of a point of a study over its mean [-], by quantity.
void add_scatter(TomlTable& table, std::map<std::string, double>& scatter) {
  const frontier::ReducedStudy solved = frontier::load_committed(table.text("study"));
  const frontier::ReducedPoint& point = point_of(table, solved);
  const auto wanted = table.texts("quantities");
  table.reject_others();
  for (const std::string& quantity : wanted) {
    const auto found = point.values.find(quantity);
    if (found == point.values.end() || point.replicates < 2)
      throw table.problem("quantities", fmt::format("study \"{}\" has no scatter of {}", solved.id, quantity));
    scatter[quantity] = error_of_mean(found->second.half_width, point.replicates) * std::sqrt(point.replicates) /
                        std::abs(found->second.value);
  }
}

Part part_of(TomlTable& table, const std::string& text) {
  for (const Part part : {Part::model, Part::discretisation, Part::statistics})
    if (to_string(part) == text) return part;
  throw table.problem("part", fmt::format("\"{}\" is none of model, discretisation, statistics", text));
}

/// Ranges of numbers that a rule states itself: { archimedes_number = [1e3, 1e6] }.
std::map<std::string, Range> ranges_of(TomlTable& rule) {
  std::map<std::string, Range> ranges;
  for (TomlTable& one : rule.tables("covered")) {
    const auto values = one.numbers("values");
    if (values.size() != 2 || !(values[0] > 0.0) || !(values[0] <= values[1]))
      throw one.problem("values", "must be the lowest and the highest number, above 0");
    ranges[one.text("number")] = {values[0], values[1]};
    one.reject_others();
  }
  return ranges;
}

}  // namespace

std::string to_string(Part part) {
  return part == Part::model ? "model" : part == Part::discretisation ? "discretisation" : "statistics";
}

std::vector<Beyond> beyond(const Rule& rule, const Rules& rules, const std::map<std::string, double>& numbers) {
  std::vector<Beyond> found;
  for (const auto& [name, range] : rule.covered) {
    const auto number = numbers.find(name);
    if (number == numbers.end() || !(number->second > 0.0)) continue;
    const double distance = std::max(std::log(range.lowest / number->second), std::log(number->second / range.highest));
    const double steps = distance / std::log(rules.reach.at(name));
    if (steps > 1.0) found.push_back({name, number->second, range, steps - 1.0});
  }
  return found;
}

double effect_beyond(const Rule& rule, const std::string& quantity, double steps) {
  const auto of = [&](const std::map<std::string, double>& values) {
    const auto found = values.find(quantity);
    return found == values.end() ? 0.0 : found->second;
  };
  return steps > 0.0 ? (1.0 + steps) * std::hypot(of(rule.effect), of(rule.standard_error)) : of(rule.effect);
}

Rules load_rules() { return load_rules(source_folder() / "experiments" / "numerics" / "plan" / "rules.toml"); }

Rules load_rules(const std::filesystem::path& file) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  Rules rules;
  rules.forces = table.texts("forces");
  const toml::table* bands = parsed["bands"].as_table();
  if (bands == nullptr) throw table.problem("bands", "is missing");
  for (const auto& [quantity, band] : *bands) rules.bands[std::string(quantity.str())] = band.value_or(0.0);
  TomlTable parts = table.table("parts");
  for (const Part part : {Part::model, Part::discretisation, Part::statistics})
    for (const std::string& subject : parts.texts(to_string(part))) rules.parts[subject] = part;
  parts.reject_others();
  rules.reach = table.numbers_by_name("reach");
  for (TomlTable& one : table.tables("bed_scatter")) add_scatter(one, rules.bed_scatter);
  rules.drop_scatter = table.numbers_by_name("drop_scatter");
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
    if (!rules.parts.contains(rule.subject))
      throw one.problem("subject", fmt::format("[parts] does not say what the error of \"{}\" is", rule.subject));
    rule.part = one.has("part") ? part_of(one, one.text("part")) : rules.parts.at(rule.subject);
    rule.covered = ranges_of(one);
    std::map<std::string, Measured> measured;
    for (TomlTable& point : one.tables("measured"))
      rule.evidence += (rule.evidence.empty() ? "" : "; ") + add_measured(point, rules.reach, measured, rule.covered);
    for (const auto& [quantity, found] : measured)
      if (rules.bands.contains(quantity) && rule.effect.try_emplace(quantity, found.error).second)
        rule.standard_error[quantity] = found.standard_error;
    if (one.flag("anywhere")) rule.covered.clear();
    for (const auto& [number, range] : rule.covered)
      if (!rules.reach.contains(number)) throw one.problem("covered", number + " stands not in [reach]");
    if (rule.evidence.empty()) throw one.problem("evidence", "is missing, and so is measured");
    one.reject_others();
    rules.list.push_back(std::move(rule));
  }
  return rules;
}

}  // namespace slfb::plan
