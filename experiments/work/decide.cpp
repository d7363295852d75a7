#include "experiments/work/decide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"

namespace slfb {
namespace {

bool undecided_by_runs(const Evaluation& evaluation) {
  return evaluation.lack == Lack::more_samples || evaluation.lack == Lack::run || evaluation.lack == Lack::steadiness;
}

/// System, velocity and variant: what the run answers.
std::string answered_by(const RunSpec& spec) { return run_key(spec.system, spec.superficial_velocity, spec.variant); }

/// The specifications that numbers are taken from.
std::vector<RunSpec> runs_for(const Work& work, const Profile& shown) {
  // Where several profiles have a run of a key, the one that is shown beside the others is made once more.
  std::vector<RunSpec> runs = shown.runs;
  std::stable_partition(runs.begin(), runs.end(),
                        [&](const RunSpec& spec) { return spec.profile == work.shown_beside; });
  return runs;
}

/// Index of the stage of fluidisation; -1 without one.
int fluidise_stage(const Scene& scene) {
  const auto found = std::ranges::find(scene.stages, StageKind::fluidise, &Stage::kind);
  return found == scene.stages.end() ? -1 : static_cast<int>(found - scene.stages.begin());
}

/// Steps towards deciding the claims of a work.
class Planner {
 public:
  Planner(const Work& work, Profile profile, std::filesystem::path out)
      : work_(work), profile_(std::move(profile)), out_(std::move(out)) {}

  std::vector<Evaluation> judge(const std::vector<Claim>& claims, const MoreRuns& more) {
    // The judgement reads them there.
    if (!more.runs.empty() || !more.looks.empty()) save_more_runs(more, more_runs_file(out_, work_));
    judgement_ = slfb::judge(work_, profile_, claims, out_);
    return judgement_->evaluations;
  }

  NextStep next_step(const Evaluation& evaluation) const {
    NextStep step;
    const std::vector<RunSpec> behind = runs_of(evaluation.claim);
    if (behind.empty()) {
      step.none = evaluation.lack == Lack::run ? "no profile has a run that answers it: a velocity is missing there"
                                               : "it rests on the runs of all systems";
      return step;
    }
    std::vector<RunSpec> missing;
    for (const RunSpec& spec : behind)
      if (!exists(spec)) missing.push_back(spec);
    if (!missing.empty()) {
      step.specs = std::move(missing);
    } else if (evaluation.lack == Lack::run) {
      step.none = "its runs exist and have no such number, or none is near its voidage";
      return step;
    } else {
      for (const RunSpec& spec : behind) add_again(spec, evaluation, step);
    }
    for (const RunSpec& spec : step.specs) step.core_seconds += cost_of(spec);
    if (evaluation.samples_needed) {
      step.core_seconds_to_decide = 0.0;
      for (const RunSpec& spec : behind)
        *step.core_seconds_to_decide +=
            cost_of(spec) * std::max(1.0, std::ceil(present(spec) * (*evaluation.samples_needed - 1.0)));
    }
    return step;
  }

  [[nodiscard]] bool rests_on(const Claim& claim, const std::vector<RunSpec>& specs) const {
    const std::vector<RunSpec> behind = runs_of(claim);
    return std::ranges::any_of(behind, [&](const RunSpec& one) {
      return std::ranges::any_of(specs, [&](const RunSpec& other) { return answered_by(one) == answered_by(other); });
    });
  }

 private:
  [[nodiscard]] std::vector<RunSpec> runs_of(const Claim& claim) const {
    std::vector<RunSpec> behind;
    std::set<std::string> keys;
    const std::vector<RunSpec> runs = runs_for(work_, judgement_->shown);
    for (const auto& measures : {claim.measures, claim.other_measures})
      for (const MeasureKey& measure : measures) {
        if (!claim.needs_run(measure)) continue;
        for (RunSpec& spec : runs_behind(measure, runs, work_, judgement_->measurements))
          if (keys.insert(spec.profile + answered_by(spec)).second) behind.push_back(std::move(spec));
      }
    return behind;
  }

  [[nodiscard]] bool exists(const RunSpec& spec) const {
    return std::filesystem::exists(result_file(out_, scene_hash(load_run_scene(spec)))) ||
           (!spec.published.empty() && std::filesystem::exists(published_file(spec)));
  }

  /// How many beds there are of what a run answers, in its profile and beyond it.
  [[nodiscard]] double present(const RunSpec& spec) const {
    return static_cast<double>(std::ranges::count_if(judgement_->shown.runs, [&](const RunSpec& other) {
      return other.profile == spec.profile && answered_by(other) == answered_by(spec);
    }));
  }

  /// As many runs once more as are needed, at most as many as there are.
  void add_again(const RunSpec& spec, const Evaluation& evaluation, NextStep& step) const {
    const double there = present(spec);
    const double needed = evaluation.samples_needed ? std::ceil(there * (*evaluation.samples_needed - 1.0)) : 1.0;
    std::uint64_t seed = load_run_scene(spec).seed;
    for (const RunSpec& other : judgement_->shown.runs)
      if (other.profile == spec.profile && other.system == spec.system) seed = std::max(seed, other.seed.value_or(0));
    MoreRun again{spec.profile, spec.system, spec.superficial_velocity, spec.variant, seed, {}};
    if (evaluation.lack == Lack::steadiness) again.overrides = longer(spec);
    for (double k = 0.0; k < std::clamp(needed, 1.0, there); ++k) {
      ++again.seed;
      step.again.push_back(again);
      step.specs.push_back(once_more(spec, again));
    }
  }

  /// Twice the longest fluidisation so far.
  [[nodiscard]] Overrides longer(const RunSpec& spec) const {
    const Scene scene = load_run_scene(spec);
    const int stage = fluidise_stage(scene);
    if (stage < 0) return {};
    double longest = scene.stages[static_cast<std::size_t>(stage)].duration;
    for (const RunSpec& other : judgement_->shown.runs)
      if (other.profile == spec.profile && answered_by(other) == answered_by(spec))
        longest = std::max(longest, load_run_scene(other).stages[static_cast<std::size_t>(stage)].duration);
    return {fmt::format("stage[{}].duration={:g} s", stage, 2.0 * longest)};
  }

  /// What such a run has cost, or is estimated to cost [s].
  [[nodiscard]] double cost_of(const RunSpec& spec) const {
    const Scene scene = load_run_scene(spec);
    for (const FinishedRun& run : judgement_->runs)
      if (run.spec.profile == spec.profile && answered_by(run.spec) == answered_by(spec) && !run.stale &&
          run.result.cpu_seconds > 0.0 && run.result.simulated_seconds > 0.0) {
        const double longer = estimate_run(scene).core_seconds / std::max(1e-9, estimate_run(run.scene).core_seconds);
        return run.result.cpu_seconds * longer;
      }
    return estimate_run(scene).core_seconds;
  }

  const Work& work_;
  Profile profile_;
  std::filesystem::path out_;
  std::optional<Judgement> judgement_;
};

/// The two runs on either side of the stated voidage, or the nearest one.
std::vector<RunSpec> about_voidage(const std::vector<RunSpec>& runs, const std::map<std::string, double>& voidages,
                                   double stated) {
  const RunSpec *below = nullptr, *above = nullptr;
  const auto voidage = [&](const RunSpec& spec) { return voidages.at(answered_by(spec)); };
  for (const RunSpec& spec : runs) {
    if (!voidages.contains(answered_by(spec))) continue;
    if (voidage(spec) < stated && (below == nullptr || voidage(spec) > voidage(*below))) below = &spec;
    if (voidage(spec) >= stated && (above == nullptr || voidage(spec) < voidage(*above))) above = &spec;
  }
  std::vector<RunSpec> found;
  for (const RunSpec* spec : {below, above})
    if (spec != nullptr) found.push_back(*spec);
  return found;
}

}  // namespace

std::vector<RunSpec> runs_behind(const MeasureKey& measure, const std::vector<RunSpec>& runs, const Work& work,
                                 const Measurements& measurements) {
  std::vector<RunSpec> of_system;
  std::set<std::string> keys;
  const bool of_one_run = measure.at.has_value() || measure.for_all_at;
  for (const RunSpec& spec : runs) {
    if (spec.seed || spec.system != measure.subject || spec.variant != (of_one_run ? measure.detail : "")) continue;
    if (keys.insert(answered_by(spec)).second) of_system.push_back(spec);
  }
  if (!measure.at) return of_system;
  const bool at_printed = measure.quantity.ends_with("_at_printed_voidage") && *measure.at > 0.3;
  const bool as_quantity =
      std::ranges::find(work.measuring.quantities, measure.quantity, &Quantity::id) != work.measuring.quantities.end();
  if (!as_quantity && (measure.quantity.ends_with("_at_voidage") || at_printed)) {
    std::map<std::string, double> voidages;
    for (const RunSpec& spec : of_system) {
      const auto ours = measurements.find(
          measure_key("voidage_centre_of_mass", spec.system, spec.superficial_velocity, spec.variant));
      const auto printed = at_printed && work.measuring.printed_voidage
                               ? work.measuring.printed_voidage(spec.system, spec.superficial_velocity)
                               : std::nullopt;
      if (at_printed && printed) voidages[answered_by(spec)] = *printed;
      if (!at_printed && ours != measurements.end()) voidages[answered_by(spec)] = ours->second.value;
    }
    return about_voidage(of_system, voidages, *measure.at);
  }
  std::erase_if(of_system, [&](const RunSpec& spec) {
    return velocity_text(spec.superficial_velocity) != velocity_text(*measure.at);
  });
  return of_system;
}

namespace {

/// The claim that is likely to be decided with the least comes first.
double expected_cost(const NextStep& step) { return step.core_seconds_to_decide.value_or(step.core_seconds); }

}  // namespace

DecideOutcome decide(const DecideWorld& world, MoreRuns more, double budget) {
  DecideOutcome outcome;
  outcome.more = std::move(more);
  for (;;) {
    outcome.evaluations = world.judge(outcome.more);
    outcome.next.assign(outcome.evaluations.size(), {});
    std::size_t cheapest = outcome.evaluations.size();
    for (std::size_t k = 0; k < outcome.evaluations.size(); ++k) {
      if (!undecided_by_runs(outcome.evaluations[k])) continue;
      NextStep& step = outcome.next[k] = world.next_step(outcome.evaluations[k]);
      if (!step.none.empty() || step.specs.empty()) continue;
      if (outcome.core_seconds + step.core_seconds > budget) continue;
      if (cheapest == outcome.evaluations.size() || expected_cost(step) < expected_cost(outcome.next[cheapest]))
        cheapest = k;
    }
    if (cheapest == outcome.evaluations.size()) return outcome;

    const NextStep step = outcome.next[cheapest];
    if (world.begin) world.begin(outcome.evaluations[cheapest], step);
    const auto spent = world.simulate(step.specs);
    outcome.interrupted = !spent;
    if (outcome.interrupted) return outcome;
    outcome.core_seconds += *spent;
    ++outcome.steps;
    outcome.more.runs.insert(outcome.more.runs.end(), step.again.begin(), step.again.end());
    // Runs that did not exist are a first look; whoever had numbers and gets more of them looks again.
    if (!step.again.empty())
      for (const Evaluation& evaluation : outcome.evaluations)
        if (evaluation.verdict == Verdict::not_decidable && evaluation.interval &&
            world.rests_on(evaluation.claim, step.specs))
          outcome.more.looks[evaluation.claim.id] = std::max(1, outcome.more.looks[evaluation.claim.id]) + 1;
    if (world.save) world.save(outcome.more);
  }
}

DecideWorld world_of(const Work& work, const Profile& profile, const std::vector<Claim>& claims,
                     const std::filesystem::path& out,
                     std::function<std::optional<double>(const std::vector<RunSpec>&)> simulate) {
  const auto planner = std::make_shared<Planner>(work, profile, out);
  DecideWorld world;
  world.judge = [planner, claims](const MoreRuns& more) { return planner->judge(claims, more); };
  world.next_step = [planner](const Evaluation& evaluation) { return planner->next_step(evaluation); };
  world.rests_on = [planner](const Claim& claim, const std::vector<RunSpec>& specs) {
    return planner->rests_on(claim, specs);
  };
  world.simulate = std::move(simulate);
  world.save = [&work, out](const MoreRuns& more) { save_more_runs(more, more_runs_file(out, work)); };
  return world;
}

std::string decide_text(const DecideOutcome& outcome) {
  std::string text;
  std::size_t width = 0, decided = 0;
  for (const Evaluation& evaluation : outcome.evaluations) width = std::max(width, evaluation.claim.id.size());
  for (std::size_t k = 0; k < outcome.evaluations.size(); ++k) {
    const Evaluation& evaluation = outcome.evaluations[k];
    if (evaluation.verdict != Verdict::not_decidable) {
      ++decided;
      continue;
    }
    const NextStep& step = outcome.next[k];
    std::string what = evaluation.reason;
    if (undecided_by_runs(evaluation)) {
      what = !step.none.empty() ? step.none
                                : fmt::format("next: {} run{}, about {} of one core", step.specs.size(),
                                              step.specs.size() == 1 ? "" : "s", format_duration(step.core_seconds));
      if (evaluation.samples_needed)
        what += std::isfinite(*evaluation.samples_needed)
                    ? fmt::format("; decided with {:.2g} times as many samples", *evaluation.samples_needed)
                    : std::string("; its mean lies on an edge, where no number of samples decides");
      if (step.core_seconds_to_decide && std::isfinite(*step.core_seconds_to_decide))
        what += fmt::format(", about {} in all", format_duration(*step.core_seconds_to_decide));
    }
    text += fmt::format("{:<{}}  lacks {:<10}  {}\n", evaluation.claim.id, width, to_string(evaluation.lack), what);
  }
  text += fmt::format("\n{} of {} claims are decided; {} step{}, {} of CPU time spent{}\n", decided,
                      outcome.evaluations.size(), outcome.steps, outcome.steps == 1 ? "" : "s",
                      format_duration(outcome.core_seconds),
                      outcome.interrupted ? "; interrupted, the same command goes on" : "");
  return text;
}

}  // namespace slfb
