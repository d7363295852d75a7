#include "experiments/claims/measured_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

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

}  // namespace

Measurements load_measured(const std::filesystem::path& file, const std::vector<Claim>& claims) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  Measurements measured;
  for (TomlTable& one : table.tables("measured")) {
    const MeasureKey key = key_of(one);
    const std::string unit = one.text("unit");
    Measurement measurement;
    measurement.value = one.number("value");
    measurement.half_width = one.number("half_width", std::numeric_limits<double>::quiet_NaN());
    measurement.unit = unit;
    measurement.origin = file.string();
    one.reject_others();
    if (std::ranges::none_of(claims, [&](const Claim& claim) { return uses(claim, key); })) {
      std::vector<std::string> known;
      for (const Claim& claim : claims)
        std::ranges::transform(claim.measures, std::back_inserter(known), [](const auto& m) { return to_string(m); });
      throw one.problem("measure", fmt::format("no claim uses \"{}\"; close: {}", to_string(key),
                                               fmt::join(close_names(to_string(key), std::move(known)), ", ")));
    }
    if (const std::string needed = unit_of(claims, key); !needed.empty() && needed != unit)
      throw one.problem("unit", fmt::format("\"{}\", but {} is needed in \"{}\"", unit, to_string(key), needed));
    if (std::isinf(measurement.value)) throw one.problem("value", "is not finite");
    if (measurement.half_width < 0.0)
      throw one.problem("half_width", fmt::format("{} is below zero", measurement.half_width));
    if (!measured.try_emplace(key, measurement).second)
      throw one.problem("measure", fmt::format("\"{}\" stands here twice", to_string(key)));
  }
  table.reject_others();
  std::erase_if(measured, [](const auto& entry) { return std::isnan(entry.second.value); });
  if (measured.empty())
    throw std::runtime_error(
        fmt::format("{}: has no [[measured]] with a value; slfb check --template prints a file "
                    "to start from",
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
    claim.printed_from = PrintedFrom::mean;  // nothing is known of the scatter of single drops
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

std::string measured_template(const std::vector<Claim>& claims) {
  std::string text =
      "# Results to be held against the claims of the paper: slfb check --measured FILE\n"
      "# value: nan where there is none. half_width: of the 95 % interval; 0 for an exact number; without it the "
      "value\n"
      "# is a single sample, which decides nothing.\n";
  std::set<MeasureKey> written;
  for (const Claim& claim : claims) {
    if (!claim.undecidable.empty()) continue;
    for (const MeasureKey& measure : claim.measures) {
      if (!claim.needs_run(measure) || !written.insert(measure).second) continue;
      text += fmt::format("\n# {}: {}; the paper: {}\n", claim.id, claim.quantity, claim.paper_text());
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
