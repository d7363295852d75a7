#include "experiments/claims/measured_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "solver/scene/units.hpp"
#include "solver/support/close_names.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

bool uses(const Claim& claim, const MeasureKey& key) {
  return std::ranges::any_of(claim.measures, [&](const MeasureKey& measure) { return stands_for(measure, key); });
}

/// The unit of a measure as the claims have it; empty where only ratios and spreads use it, which have one of their
/// own.
std::string unit_of(const std::vector<Claim>& claims, const MeasureKey& key) {
  for (const Claim& claim : claims)
    if (uses(claim, key) && claim.reduction != Reduction::ratio && claim.reduction != Reduction::relative_spread)
      return claim.unit;
  return "";
}

MeasureKey key_of(TomlTable& table) {
  try {
    return parse_measure_key(table.text("measure"));
  } catch (const std::invalid_argument& error) {
    throw table.problem("measure", error.what());
  }
}

/// One value with its interval, in the unit of the claims where these have one.
Measurement value_of(TomlTable& table, const MeasureKey& key, const std::string& needed,
                     const std::filesystem::path& file) {
  const std::string unit = table.text("unit");
  Measurement measurement;
  measurement.value = table.number("value");
  measurement.half_width = table.number("half_width", std::numeric_limits<double>::quiet_NaN());
  const std::vector<double> ends = table.numbers("interval");
  measurement.origin = file.string();
  table.reject_others();
  double factor = 1.0;
  if (!needed.empty() && needed != unit) {
    const auto known = needed == "-" || unit == "-" ? std::nullopt : units::unit_factor(unit, needed);
    if (!known)
      throw table.problem("unit", fmt::format("\"{}\", but {} is needed in \"{}\" or what measures the same", unit,
                                              to_string(key), needed));
    factor = *known;
  }
  measurement.unit = needed.empty() ? unit : needed;
  if (std::isinf(measurement.value)) throw table.problem("value", "is not finite");
  if (measurement.half_width < 0.0)
    throw table.problem("half_width", fmt::format("{} is below zero", measurement.half_width));
  measurement.value *= factor;
  measurement.half_width *= factor;
  if (!ends.empty()) {
    if (ends.size() != 2 || !(ends[0] <= ends[1])) throw table.problem("interval", "has to be two numbers that rise");
    measurement.interval = {factor * ends[0], factor * ends[1]};
  }
  return measurement;
}

/// From which records a quantity follows; empty where from none.
std::string records_for(const Quantity& quantity) {
  std::vector<std::string> records;
  for (const Recorded recorded : quantity.needs) records.push_back(recorded_as(recorded));
  return fmt::format("{}", fmt::join(records, "; and "));
}

std::string number_text(double value) { return std::isnan(value) ? "nan" : fmt::format("{}", value); }

}  // namespace

Measurements load_measured(const std::filesystem::path& file, const std::vector<Claim>& claims,
                           const MeasuredSystems& systems) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  Measurements measured = measure_records(table, file.parent_path(), file.string(), systems);
  const bool has_series = table.has("series");
  std::erase_if(measured, [&](const auto& entry) {
    return std::ranges::none_of(claims, [&](const Claim& claim) { return uses(claim, entry.first); });
  });
  for (TomlTable& one : table.tables("measured")) {
    const MeasureKey key = key_of(one);
    if (std::ranges::none_of(claims, [&](const Claim& claim) { return uses(claim, key); })) {
      std::vector<std::string> known;
      for (const Claim& claim : claims)
        std::ranges::transform(claim.measures, std::back_inserter(known), [](const auto& m) { return to_string(m); });
      throw one.problem("measure", fmt::format("no claim uses \"{}\"; close: {}", to_string(key),
                                               fmt::join(close_names(to_string(key), std::move(known)), ", ")));
    }
    const Measurement measurement = value_of(one, key, unit_of(claims, key), file);
    if (!measured.try_emplace(key, measurement).second)
      throw one.problem("measure",
                        fmt::format("\"{}\" stands here twice, or a [[series]] gives it too", to_string(key)));
  }
  table.reject_others();
  std::erase_if(measured, [](const auto& entry) { return std::isnan(entry.second.value); });
  if (measured.empty())
    throw std::runtime_error(
        has_series
            ? fmt::format("{}: no claim uses what can be reduced from its [[series]]", file.string())
            : fmt::format("{}: has no [[measured]] with a value, and no [[series]]; slfb check --template prints a "
                          "file to start from",
                          file.string()));
  return measured;
}

std::vector<Evaluation> evaluate_measured(const std::vector<Claim>& claims, const Measurements& measured) {
  std::vector<Evaluation> evaluations;
  for (Claim claim : claims) {
    std::vector<std::string> missing;
    for (const MeasureKey& measure : claim.measures)
      if (std::ranges::none_of(measured, [&](const auto& entry) { return stands_for(measure, entry.first); }))
        missing.push_back(to_string(measure));
    if (missing.size() == claim.measures.size()) continue;
    claim.regression_band.reset();  // of this suite's own results
    if (std::ranges::none_of(claim.other_measures, [&](const MeasureKey& measure) {
          return std::ranges::any_of(measured, [&](const auto& entry) { return stands_for(measure, entry.first); });
        }))
      claim.other_measures.clear();
    const bool scatter_is_known = std::ranges::all_of(claim.measures, [&](const MeasureKey& measure) {
      return std::ranges::all_of(measured, [&](const auto& entry) {
        return !stands_for(measure, entry.first) || !std::isnan(entry.second.scatter);
      });
    });
    if (!scatter_is_known) claim.printed_from = PrintedFrom::mean;
    Evaluation evaluation = evaluate({claim}, measured).front();
    if (!missing.empty() && claim.undecidable.empty())
      evaluation.reason = fmt::format("not measured: {}", fmt::join(missing, "; "));
    evaluation.gate = evaluation.verdict == Verdict::reproduced       ? Gate::holds
                      : evaluation.verdict == Verdict::not_reproduced ? Gate::broken
                                                                      : Gate::none;
    evaluations.push_back(std::move(evaluation));
  }
  return evaluations;
}

std::string measured_text(const Measurements& measured) {
  std::string text = "# Results of slfb check --measured\n";
  for (const auto& [key, value] : measured) {
    text += fmt::format("\n[[measured]]\nmeasure = \"{}\"\nvalue = {}\nunit = \"{}\"\n", to_string(key),
                        number_text(value.value), value.unit);
    if (!std::isnan(value.half_width)) text += fmt::format("half_width = {}\n", number_text(value.half_width));
    if (value.interval)
      text +=
          fmt::format("interval = [{}, {}]\n", number_text(value.interval->first), number_text(value.interval->second));
  }
  return text;
}

std::string measured_template(const std::vector<Claim>& claims, const MeasuredSystems& systems) {
  std::string text = "# Results to be held against the claims of the paper: slfb check --measured FILE\n#\n" +
                     records_help(systems) +
                     "#\n"
                     "# Or state values. value: nan where there is none. half_width: of the 95 % interval; 0 for an "
                     "exact number;\n"
                     "# interval = [lower, upper] where it is not symmetric; without either the value is a single "
                     "sample, which decides\n# nothing. unit: any that measures the same.\n";
  std::set<MeasureKey> written;
  std::set<std::string> defined;
  for (const Claim& claim : claims) {
    if (!claim.undecidable.empty()) continue;
    for (const MeasureKey& measure : claim.measures) {
      if (!claim.needs_run(measure) || !written.insert(measure).second) continue;
      text += fmt::format("\n# {}: {}; the paper: {}\n", claim.id, claim.quantity, claim.paper_text());
      if (const Quantity* quantity = find_quantity(systems.rules, measure.quantity);
          quantity != nullptr && defined.insert(quantity->id).second) {
        text += fmt::format("# {}: {}\n", quantity->id, quantity->definition);
        if (!quantity->needs.empty()) text += fmt::format("# Reduced from {}.\n", records_for(*quantity));
      }
      const bool any_velocity = measure.for_all_at;
      if (any_velocity) text += "# For every U_L [m/s] in the place of *:\n";
      text +=
          fmt::format("{0}[[measured]]\n{0}measure = \"{1}\"\n{0}value = nan\n{0}half_width = nan\n{0}unit = \"{2}\"\n",
                      any_velocity ? "# " : "", to_string(measure), unit_of(claims, measure));
    }
  }
  return text;
}

}  // namespace slfb
