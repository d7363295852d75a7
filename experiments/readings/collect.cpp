#include "experiments/readings/collect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/quantities/run_summary.hpp"

namespace slfb::readings {
namespace {

/// A run with what was measured in it.
struct Measured {
  const FinishedRun* run;
  RunSummary summary;
};

std::optional<Reading> reading_of(const Choices& choices, const std::string& variant) {
  if (variant.empty()) return std::nullopt;
  try {
    return choices.reading_named(variant);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // a variant of another kind
  }
}

const Quantity& quantity_of(const MeasuringRules& rules, const Evidence& evidence) {
  const Quantity* quantity = find_quantity(rules, evidence.printed.quantity);
  if (quantity == nullptr)
    throw std::invalid_argument("readings: there is no quantity \"" + evidence.printed.quantity + "\"");
  return *quantity;
}

bool is_of_drops(const Quantity& quantity) {
  return !std::holds_alternative<OfBed>(quantity.computed) && !std::holds_alternative<OfRun>(quantity.computed);
}

/// Its runs that answer a piece of evidence: of the last profile that has any, by seed.
std::vector<const Measured*> answering(const Evidence& evidence, const std::vector<Measured>& runs,
                                       const MeasuringRules& rules) {
  std::vector<const Measured*> found;
  for (const Measured& one : runs) {
    const RunSpec& spec = one.run->spec;
    if (spec.system != evidence.system) continue;
    if (evidence.superficial_velocity && std::abs(spec.superficial_velocity - *evidence.superficial_velocity) > 1e-9)
      continue;
    if (depends_on_contact_stiffness(rules, evidence.printed.quantity) &&
        one.run->scene.contact.stiffness != load_scene(spec.scene).contact.stiffness)
      continue;
    if (!found.empty() && found.back()->run->spec.profile != spec.profile) found.clear();
    found.push_back(&one);
  }
  std::ranges::stable_sort(found, {}, [](const Measured* one) { return one->run->scene.seed; });
  return found;
}

/// Of one bed: value and standard error by its own series.
using OfSeed = std::map<std::uint64_t, std::pair<double, double>>;

OfSeed beds(const std::string& quantity, const std::vector<const Measured*>& runs) {
  OfSeed values;
  for (const Measured* one : runs) {
    const auto seed = one->run->scene.seed;
    if (const auto bed = one->summary.bed.find(quantity); bed != one->summary.bed.end()) {
      const double error = bed->second.half_width / inside_95_percent / bed->second.mean;
      values.emplace(seed, std::pair{std::log(bed->second.mean), std::isfinite(error) ? error : 0.0});
    } else if (const auto value = one->summary.run.find(quantity); value != one->summary.run.end()) {
      values.emplace(seed, std::pair{std::log(value->second), 0.0});
    }
  }
  return values;
}

std::vector<double> drops(const Quantity& quantity, const std::vector<const Measured*>& runs,
                          const MeasuringRules& rules) {
  std::vector<double> samples;
  for (const Measured* one : runs)
    for (const auto& drop : one->summary.drops) {
      const RunSpec& spec = one->run->spec;
      const DropNumbers numbers{drop, one->summary.bed, one->run->scene, rules, spec.system, spec.superficial_velocity};
      const auto* computed = std::get_if<OfDropNumbers>(&quantity.computed);
      const auto value = computed == nullptr ? numbers.of_drop(quantity.id) : (*computed)(numbers);
      samples.push_back(value && *value > 0.0 ? std::log(*value) : std::numeric_limits<double>::quiet_NaN());
    }
  return samples;
}

ReadingRuns runs_of(const Reading& reading, const std::vector<Evidence>& evidence, const std::vector<Measured>& runs,
                    const MeasuringRules& rules) {
  ReadingRuns result{reading, std::vector<std::vector<double>>(evidence.size()),
                     std::vector<double>(evidence.size(), 0.0)};
  std::map<std::string, std::map<std::size_t, OfSeed>> blocks;
  std::map<std::string, std::vector<std::size_t>> drop_blocks;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const auto found = answering(evidence[i], runs, rules);
    const Quantity& quantity = quantity_of(rules, evidence[i]);
    if (is_of_drops(quantity)) {
      result.samples[i] = drops(quantity, found, rules);
      drop_blocks[evidence[i].printed.block].push_back(i);
    } else if (OfSeed values = beds(evidence[i].printed.quantity, found); !values.empty()) {
      blocks[evidence[i].printed.block][i] = std::move(values);
    }
  }
  // A sphere that does not arrive lacks the numbers of its passage together: what is missing alone was not recorded.
  const auto has_any = [&](std::size_t i) {
    return std::ranges::any_of(result.samples[i], [](double sample) { return std::isfinite(sample); });
  };
  for (const auto& [name, numbers] : drop_blocks) {
    const bool recorded = std::ranges::any_of(numbers, has_any);
    for (const std::size_t i : numbers)
      if (recorded && !has_any(i)) result.samples[i].clear();
  }
  for (const auto& [name, numbers] : blocks)
    for (const auto& entry_of_seed : numbers.begin()->second) {
      const auto& seed = entry_of_seed.first;  // clang 14 takes no name of a structured binding into a lambda
      if (!std::ranges::all_of(numbers, [&](const auto& entry) { return entry.second.contains(seed); })) continue;
      for (const auto& [i, values] : numbers) {
        result.samples[i].push_back(values.at(seed).first);
        result.own_errors[i] = std::max(result.own_errors[i], values.at(seed).second);
      }
    }
  return result;
}

}  // namespace

std::vector<PrintedNumber> printed_numbers(const std::vector<Evidence>& evidence) {
  std::vector<PrintedNumber> numbers;
  for (const Evidence& one : evidence) numbers.push_back(one.printed);
  return numbers;
}

std::vector<NamedRuns> collect(const Choices& choices, const std::vector<Evidence>& evidence,
                               const std::vector<FinishedRun>& runs, const MeasuringRules& rules) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<Measured>> of_reading;
  for (const FinishedRun& run : runs) {
    if (run.stale || !reading_of(choices, run.spec.variant)) continue;
    auto& list = of_reading[run.spec.variant];
    if (list.empty()) order.push_back(run.spec.variant);
    list.push_back({&run, run.summary ? *run.summary : summarise(run.spec.system, run.scene, run.result, rules)});
  }
  std::vector<NamedRuns> collected;
  for (const std::string& name : order)
    collected.push_back({name, runs_of(*reading_of(choices, name), evidence, of_reading[name], rules)});
  return collected;
}

}  // namespace slfb::readings
