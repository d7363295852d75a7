#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/quantities/over_runs.hpp"
#include "experiments/quantities/run_summary.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/laws/scene_file.hpp"

namespace slfb {
namespace {

/// What several runs of a scene may have otherwise and still be samples of one number: their seed, their times, steps
/// and springs, the height of the column. What is left of the scene is its model.
/// A packed bed does not feel the grid of the liquid either: cells of 6.25 and 7.14 mm differ by 0.2 % in the pressure
/// drop of one packing, three packings by 1 % (profiles full and packed of Peng 2014, 0.03 m/s). It does feel its
/// springs: with a tangential spring of a hundredth it packs to 0.384 at 1e3 N/m and to 0.405 at 1e4 N/m (profile
/// packed).
Scene model_of(Scene scene, const Scene& pattern, bool packed) {
  if (packed) {
    scene.fluid.cells_across = pattern.fluid.cells_across;
    scene.fluid.cell_height = pattern.fluid.cell_height;
  }
  scene.title = pattern.title;
  scene.seed = pattern.seed;
  scene.geometry.height = pattern.geometry.height;
  scene.fluid.time_step = pattern.fluid.time_step;
  scene.fluid.cell_height =
      std::abs(scene.fluid.cell_height - pattern.fluid.cell_height) < 1e-3 * pattern.fluid.cell_height
          ? pattern.fluid.cell_height
          : scene.fluid.cell_height;
  if (!packed) scene.contact.stiffness = pattern.contact.stiffness;
  scene.contact.time_step = pattern.contact.time_step;
  scene.contact.allow_large_time_step = pattern.contact.allow_large_time_step;
  scene.recording = pattern.recording;
  for (std::size_t k = 0; k < std::min(scene.stages.size(), pattern.stages.size()); ++k) {
    scene.stages[k].duration = pattern.stages[k].duration;
    scene.stages[k].repetitions = pattern.stages[k].repetitions;
    scene.stages[k].release_height = pattern.stages[k].release_height;
    scene.stages[k].relaxation = pattern.stages[k].relaxation;
  }
  return scene;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(std::move(line));
  std::ranges::sort(lines);
  return lines;
}

/// How many lines of its canonical text a model has otherwise than another.
std::size_t distance(const std::vector<std::string>& model, const std::vector<std::string>& other) {
  std::vector<std::string> differing;
  std::ranges::set_symmetric_difference(model, other, std::back_inserter(differing));
  return differing.size();
}

/// Runs of different models are no samples of one number: of those of one key, the ones whose model is nearest to the
/// scene of the work stay.
void keep_nearest_model(std::vector<const FinishedRun*>& runs, const MeasuringRules& rules) {
  if (runs.size() < 2) return;
  const Scene& pattern = runs.front()->scene;
  const bool packed = runs.front()->spec.superficial_velocity <= rules.packed_up_to;
  std::vector<std::vector<std::string>> models;
  for (const FinishedRun* run : runs) models.push_back(lines_of(canonical_toml(model_of(run->scene, pattern, packed))));
  if (std::ranges::all_of(models, [&](const auto& model) { return model == models.front(); })) return;
  const RunSpec& spec = runs.front()->spec;
  const std::filesystem::path& of_work = spec.system_scene.empty() ? spec.scene : spec.system_scene;
  const auto source = lines_of(canonical_toml(model_of(load_scene(of_work, {}), pattern, packed)));
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < models.size(); ++k)
    if (distance(models[k], source) < distance(models[nearest], source)) nearest = k;
  std::vector<const FinishedRun*> kept;
  for (std::size_t k = 0; k < models.size(); ++k)
    if (models[k] == models[nearest]) kept.push_back(runs[k]);
  runs = std::move(kept);
}

/// All runs that answer one key.
class RunGroup {
 public:
  RunGroup(const RunSpec& spec, const std::vector<const FinishedRun*>& runs, const MeasuringRules& rules,
           Measurements& measurements)
      : spec_(spec), rules_(rules), measurements_(measurements) {
    for (const FinishedRun* run : runs) {
      origin_ += (origin_.empty() ? "" : ", ") + run->result.name;
      runs_.push_back({*run, run->summary ? *run->summary : summary_of(*run)});
      if (run->summary) complete(runs_.back().summary, spec.system, run->scene, run->result, rules);
    }
    packed_ = spec.superficial_velocity <= rules.packed_up_to;
    mark_steady();
  }

  void measure() {
    for (const Quantity& quantity : rules_.quantities) {
      if (std::holds_alternative<OfBed>(quantity.computed)) {
        pool_series_of(quantity);
      } else if (std::holds_alternative<OfRun>(quantity.computed)) {
        pool_numbers_of_runs(quantity);
      } else if (std::holds_alternative<OfDrop>(quantity.computed) ||
                 std::holds_alternative<OfDropNumbers>(quantity.computed)) {
        pool_drops(quantity);
      } else if (const auto* computed = std::get_if<OfReplicates>(&quantity.computed)) {
        std::vector<RunSummary> summaries;
        for (const Member& member : runs_) summaries.push_back(member.summary);
        if (const auto value = (*computed)(summaries)) add(quantity, {.mean = *value, .samples = summaries.size()});
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

  struct Member {
    const FinishedRun& run;
    RunSummary summary;
    double drift = 0.0;  ///< of its voidage
    bool steady = true;
  };

  /// Runs whose beds still expand say nothing of the bed at rest: they count only where no other run does.
  void mark_steady() {
    for (Member& member : runs_) {
      const auto found = member.summary.run.find("voidage_drift");
      member.drift = found == member.summary.run.end() ? 0.0 : found->second;
      member.steady = std::abs(member.drift) <= rules_.steady_voidage;
    }
    any_steady_ = std::ranges::any_of(runs_, &Member::steady);
  }
  [[nodiscard]] bool counts(const Member& member) const { return member.steady || !any_steady_; }

  Measurement& add(const Quantity& quantity, const PooledEstimate& estimate) {
    Measurement& added =
        measurements_[measure_key(quantity.id, spec_.system, spec_.superficial_velocity, spec_.variant)];
    added = {estimate.mean, estimate.half_width, estimate.samples, quantity.unit, origin_};
    added.lowest = quantity.lowest;
    added.highest = quantity.highest;
    added.steady = any_steady_;
    if (!any_steady_)
      added.remark = fmt::format(
          "the bed was not steady: its voidage still changed by {:+.3f} at the end of its series", runs_.front().drift);
    return added;
  }

  /// Means of the undisturbed bed. Below fluidisation they are of the packing: runs that begin with the same one are
  /// one sample, however long their series.
  void pool_series_of(const Quantity& quantity) {
    std::vector<SeriesEstimate> series;
    std::map<std::uint64_t, std::vector<double>> packings;
    for (const Member& member : runs_) {
      const auto found = member.summary.bed.find(quantity.id);
      if (found == member.summary.bed.end() || !counts(member)) continue;
      series.push_back(found->second);
      packings[member.run.scene.seed].push_back(found->second.mean);
    }
    if (series.empty()) return;
    if (packed_) return of_packings(quantity, packings);
    PooledEstimate estimate = pool_series(series);
    // The error of a series that still drifts is not that of its fluctuation.
    if (!any_steady_) estimate.half_width = std::numeric_limits<double>::quiet_NaN();
    add(quantity, estimate);
  }

  void of_packings(const Quantity& quantity, const std::map<std::uint64_t, std::vector<double>>& packings) {
    std::vector<double> means;
    for (const auto& [seed, values] : packings)
      means.push_back(std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()));
    Measurement& added = add(quantity, pool_beds(std::vector<std::vector<double>>{means}));
    if (means.size() == 1) added.remark = "one packing only, so no interval";
  }

  void pool_numbers_of_runs(const Quantity& quantity) {
    std::vector<double> values;
    std::map<std::uint64_t, std::vector<double>> packings;
    for (const Member& member : runs_)
      if (const auto found = member.summary.run.find(quantity.id); found != member.summary.run.end()) {
        values.push_back(found->second);
        packings[member.run.scene.seed].push_back(found->second);
      }
    if (values.empty()) return;
    if (quantity.of_packing) return of_packings(quantity, packings);
    add(quantity, pool_beds(std::vector<std::vector<double>>{values}));
  }

  [[nodiscard]] std::optional<BoundedSample> sample(const Quantity& quantity, const Member& member,
                                                    const std::map<std::string, double>& drop) const {
    if (const auto* computed = std::get_if<OfDropNumbers>(&quantity.computed))
      if (const auto value = (*computed)(
              {drop, member.summary.bed, member.run.scene, rules_, spec_.system, spec_.superficial_velocity}))
        return BoundedSample{*value};
    return sample_of(drop, quantity.id);
  }

  void pool_drops(const Quantity& quantity) {
    std::vector<std::vector<double>> beds;
    std::vector<BoundedSample> samples;
    for (const Member& member : runs_) {
      if (!counts(member)) continue;
      std::vector<double>& bed = beds.emplace_back();
      for (const auto& drop : member.summary.drops)
        if (const auto one = sample(quantity, member, drop)) {
          samples.push_back(*one);
          if (one->kind == BoundedSample::Kind::exact) bed.push_back(one->value);
        }
    }
    if (samples.empty()) return;
    const auto bounds = static_cast<std::size_t>(std::ranges::count_if(
        samples, [](const BoundedSample& one) { return one.kind != BoundedSample::Kind::exact; }));
    if (bounds > 0) return of_median(quantity, samples, bounds);
    const PooledEstimate estimate = with_resolution(pool_beds(beds), quantity.step);
    Measurement& added = add(quantity, estimate);
    added.scatter = estimate.scatter;
    if (!quantity.yes_or_no) return;
    const auto yes = std::ranges::count_if(samples, [](const BoundedSample& one) { return one.value > 0.5; });
    added.interval = share_interval(static_cast<std::size_t>(yes), samples.size());
    added.scatter = std::numeric_limits<double>::quiet_NaN();
  }

  /// Drops that were not followed to their end are evidence too: of the median, which needs no more than their order.
  void of_median(const Quantity& quantity, const std::vector<BoundedSample>& samples, std::size_t bounds) {
    const MedianEstimate median = estimate_median(samples);
    Measurement& added =
        add(quantity,
            {.mean = median.value, .half_width = std::numeric_limits<double>::quiet_NaN(), .samples = samples.size()});
    if (std::isfinite(median.lower) || std::isfinite(median.upper)) added.interval = {median.lower, median.upper};
    added.remark =
        fmt::format("{} of {} drops had not come to their end when last seen: of their median", bounds, samples.size());
  }

  const RunSpec& spec_;
  const MeasuringRules& rules_;
  std::vector<Member> runs_;
  std::string origin_;
  bool packed_ = false, any_steady_ = true;
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
  const auto ours = over_numbers(measurements, "voidage_centre_of_mass", system);
  std::map<double, Measurement> printed;
  if (rules.printed_voidage)
    for (const auto& [velocity, voidage] : ours)
      if (const auto of_the_work = rules.printed_voidage(system, velocity))
        printed[velocity] = {.value = *of_the_work, .unit = "-"};
  for (const std::string& quantity : rules.at_voidages)
    for (const double stated : rules.printed_voidages)
      for (const auto& [voidages, ending] : {std::pair{&ours, "_at_voidage"}, {&printed, "_at_printed_voidage"}}) {
        auto answer =
            value_at_voidage(*voidages, over_numbers(measurements, quantity, system), stated, rules.voidage_tolerance);
        if (!answer) continue;
        answer->origin = "runs of " + system + " over the voidage";
        measurements[measure_key(quantity + ending, system, stated)] = *answer;
      }
}

}  // namespace

void take_contacts_from(const Measurements& of_the_scene, const MeasuringRules& rules, Measurements& measurements) {
  std::map<std::string, int> velocities;
  const auto of_contacts = [&](const MeasureKey& key) {
    return key.detail.empty() && depends_on_contact_stiffness(rules, key.quantity);
  };
  for (const auto& [key, measured] : of_the_scene)
    if (key.at && of_contacts(key) && key.quantity == "collision_frequency") ++velocities[key.subject];
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

std::vector<FinishedRun> take_out_other_models(std::vector<FinishedRun>& runs, const MeasuringRules& rules) {
  std::map<std::string, std::vector<const FinishedRun*>> groups;
  for (const FinishedRun& run : runs)
    if (!run.stale) groups[run_key(run.spec.system, run.spec.superficial_velocity, run.spec.variant)].push_back(&run);
  std::set<const FinishedRun*> kept;
  for (auto& [key, group] : groups) {
    keep_nearest_model(group, rules);
    kept.insert(group.begin(), group.end());
  }
  std::vector<FinishedRun> stay, others;
  for (FinishedRun& run : runs) (run.stale || kept.contains(&run) ? stay : others).push_back(std::move(run));
  runs = std::move(stay);
  return others;
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
    keep_nearest_model(group, rules);
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
