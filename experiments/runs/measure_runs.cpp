#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "experiments/quantities/over_runs.hpp"
#include "experiments/quantities/run_summary.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

/// All runs that answer one key.
class RunGroup {
 public:
  RunGroup(const RunSpec& spec, const std::vector<const FinishedRun*>& runs, const MeasuringRules& rules,
           Measurements& measurements)
      : spec_(spec), rules_(rules), measurements_(measurements) {
    for (const FinishedRun* run : runs) {
      origin_ += (origin_.empty() ? "" : ", ") + run->result.name;
      summaries_.push_back(run->summary ? *run->summary : summary_of(*run));
    }
  }

  void measure() {
    for (const Quantity& quantity : rules_.quantities) {
      std::vector<double> samples;
      const auto collect = [&](const std::map<std::string, double>& numbers) {
        if (const auto found = numbers.find(quantity.id); found != numbers.end()) samples.push_back(found->second);
      };
      if (std::holds_alternative<OfBed>(quantity.computed)) {
        pool_bed(quantity);
      } else if (std::holds_alternative<OfRun>(quantity.computed)) {
        for (const RunSummary& summary : summaries_) collect(summary.run);
        pool(quantity, samples);
      } else if (std::holds_alternative<OfDrop>(quantity.computed)) {
        for (const RunSummary& summary : summaries_)
          for (const auto& drop : summary.drops) collect(drop);
        pool(quantity, samples);
      } else if (const auto* computed = std::get_if<OfReplicates>(&quantity.computed)) {
        if (const auto value = (*computed)(summaries_)) add(quantity, *value, 0.0, summaries_.size());
      }
    }
  }

 private:
  [[nodiscard]] RunSummary summary_of(const FinishedRun& run) const {
    try {
      return summarise(spec_.system, run.scene, run.result, rules_);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("the result of run {} ({}) cannot be measured: {}", run.result.name,
                                           run_key(run.spec), error.what()));
    }
  }

  void add(const Quantity& quantity, double value, double half_width, std::size_t samples) {
    measurements_[measure_key(quantity.id, spec_.system, spec_.superficial_velocity, spec_.variant)] = {
        value, half_width, samples, quantity.unit, origin_};
  }

  /// Means of the undisturbed bed: of one run with the interval of its own series, of several together.
  void pool_bed(const Quantity& quantity) {
    std::vector<SeriesEstimate> runs;
    for (const RunSummary& summary : summaries_)
      if (const auto found = summary.bed.find(quantity.id); found != summary.bed.end()) runs.push_back(found->second);
    if (runs.empty()) return;
    const auto samples = [&] {
      double sum = 0.0;
      for (const SeriesEstimate& run : runs) sum += run.effective_samples;
      return static_cast<std::size_t>(std::max(1.0, sum));
    };
    const bool weighable =
        std::all_of(runs.begin(), runs.end(), [](const SeriesEstimate& run) { return run.half_width > 0.0; });
    if (runs.size() == 1) {
      add(quantity, runs.front().mean, runs.front().half_width, samples());
    } else if (weighable) {
      const auto [mean, half_width] = weighted_mean(runs);
      add(quantity, mean, half_width, samples());
    } else {
      std::vector<double> means;
      for (const SeriesEstimate& run : runs) means.push_back(run.mean);
      pool(quantity, means);
    }
  }

  /// Independent samples.
  void pool(const Quantity& quantity, const std::vector<double>& samples) {
    if (samples.empty()) return;
    const ReplicateEstimate estimate = estimate_replicates(samples);
    add(quantity, estimate.mean, estimate.half_width, estimate.samples);
  }

  /// Mean weighted by the intervals, and its interval: wider by the ratio of Birge (1932, Phys. Rev. 40, 207) where the
  /// runs scatter more than their own intervals say.
  static std::pair<double, double> weighted_mean(const std::vector<SeriesEstimate>& runs) {
    double weights = 0.0, mean = 0.0, scatter = 0.0;
    for (const SeriesEstimate& run : runs) weights += 1.0 / (run.half_width * run.half_width);
    for (const SeriesEstimate& run : runs) mean += run.mean / (run.half_width * run.half_width * weights);
    for (const SeriesEstimate& run : runs) scatter += std::pow((run.mean - mean) / (0.5 * run.half_width), 2);
    const double birge = std::sqrt(scatter / static_cast<double>(runs.size() - 1));
    return {mean, std::max(1.0, birge) / std::sqrt(weights)};
  }

  const RunSpec& spec_;
  const MeasuringRules& rules_;
  std::vector<RunSummary> summaries_;
  std::string origin_;
  Measurements& measurements_;
};

/// What follows from all runs of a system together.
void measure_system(const std::string& system, const MeasuringRules& rules, Measurements& measurements) {
  for (const Quantity& quantity : rules.quantities) {
    const auto* computed = std::get_if<OfSystem>(&quantity.computed);
    auto answer = computed == nullptr ? std::nullopt : (*computed)(measurements, system, rules);
    if (!answer) continue;
    answer->unit = quantity.unit;
    answer->origin = "runs of " + system + " over U_L";
    measurements[{quantity.id, system}] = *answer;
  }
  const auto voidages = over_numbers(measurements, "voidage_centre_of_mass", system);
  for (const std::string& quantity : rules.at_voidages)
    for (const double stated : rules.printed_voidages) {
      auto answer =
          value_at_voidage(voidages, over_numbers(measurements, quantity, system), stated, rules.voidage_tolerance);
      if (!answer) continue;
      answer->origin = "runs of " + system + " over the voidage";
      measurements[measure_key(quantity + "_at_voidage", system, stated)] = *answer;
    }
}

}  // namespace

void take_contacts_from(const Measurements& of_the_scene, const MeasuringRules& rules, Measurements& measurements) {
  std::map<std::string, int> velocities;
  const auto of_contacts = [&](const MeasureKey& key) {
    return key.at && key.detail.empty() && depends_on_contact_stiffness(rules, key.quantity);
  };
  for (const auto& [key, measured] : of_the_scene)
    if (of_contacts(key) && key.quantity == "collision_frequency") ++velocities[key.subject];
  const auto changes_over = [&](const MeasureKey& key) {
    const auto found = velocities.find(key.subject);
    return found != velocities.end() && found->second >= 2 && of_contacts(key);
  };
  std::erase_if(measurements, [&](const auto& entry) { return changes_over(entry.first); });
  for (auto& [key, measured] : measurements)
    if (of_contacts(key)) measured.springs = Springs::softened;
  for (const auto& [key, measured] : of_the_scene) {
    if (!changes_over(key)) continue;
    measurements[key] = measured;
    measurements[key].springs = Springs::own;
  }
}

Measurements measure_runs(const std::vector<FinishedRun>& runs, const MeasuringRules& rules) {
  std::map<std::string, std::vector<const FinishedRun*>> groups;
  for (const FinishedRun& run : runs)
    groups[run_key(run.spec.system, run.spec.superficial_velocity, run.spec.variant)].push_back(&run);

  Measurements measurements;
  std::set<std::string> systems;
  for (auto& [key, group] : groups) {
    if (std::any_of(group.begin(), group.end(), [](const FinishedRun* run) { return !run->stale; })) {
      std::erase_if(group, [](const FinishedRun* run) { return run->stale; });
    }
    std::set<std::string> names;
    std::erase_if(group, [&](const FinishedRun* run) { return !names.insert(run->result.name).second; });
    RunGroup(group.front()->spec, group, rules, measurements).measure();
    systems.insert(group.front()->spec.system);
  }
  for (const std::string& system : systems) measure_system(system, rules, measurements);
  for (const Quantity& quantity : rules.quantities)
    if (const auto* computed = std::get_if<OfAllSystems>(&quantity.computed))
      if (auto answer = (*computed)(measurements)) {
        answer->unit = quantity.unit;
        answer->origin = "runs of all systems";
        measurements[{quantity.id, std::string(all_systems)}] = *answer;
      }
  return measurements;
}

}  // namespace slfb
