#include "experiments/compare/candidates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"

namespace slfb::compare {
namespace {

/// Whether a measure of the claim is taken in that run; "quantity/system" is taken in all runs of the system.
bool asks_for(const Claim& claim, const RunSpec& run) {
  return std::ranges::any_of(claim.measures, [&](const MeasureKey& measure) {
    const bool of_all_runs = measure.subject == run.system && !measure.at && measure.detail.empty();
    return of_all_runs || measure == measure_key(measure.quantity, run.system, run.superficial_velocity, run.variant);
  });
}

RunSpec with(RunSpec run, const Candidate& candidate) {
  run.overrides.insert(run.overrides.end(), candidate.overrides.begin(), candidate.overrides.end());
  return run;
}

/// How far a number is from what the paper states; 0 where it is as stated.
double distance(const Claim& claim, double ours) {
  switch (claim.kind) {
    case StatementKind::at_most:
      return std::max(0.0, ours - claim.paper);
    case StatementKind::at_least:
      return std::max(0.0, claim.paper - ours);
    case StatementKind::between:
      return std::max({0.0, claim.paper - ours, ours - claim.paper_upper});
    default:
      return std::abs(ours - claim.paper);
  }
}

/// Nearer to "reproduced" is more.
int rank(Verdict verdict) { return verdict == Verdict::reproduced ? 2 : verdict == Verdict::not_decidable ? 1 : 0; }

}  // namespace

std::vector<Claim> claims_of_runs(const ComparisonBed& bed, const std::vector<std::string>& ids) {
  std::vector<Claim> claims;
  for (const Claim& claim : bed.claims)
    if (claim.needs_run()) claims.push_back(claim);
  for (const std::string& id : ids)
    if (std::ranges::none_of(claims, [&](const Claim& claim) { return claim.id.starts_with(id); })) {
      std::vector<std::string> figures;
      for (const Claim& claim : claims)
        if (std::ranges::find(figures, claim.figure) == figures.end()) figures.push_back(claim.figure);
      throw std::invalid_argument(
          fmt::format("no claim that a simulation answers begins with \"{}\"; such claims are of {}", id,
                      fmt::join(figures, ", ")));
    }
  if (!ids.empty())
    std::erase_if(claims, [&](const Claim& claim) {
      return std::ranges::none_of(ids, [&](const std::string& id) { return claim.id.starts_with(id); });
    });
  return claims;
}

std::vector<RunSpec> runs_of(const ComparisonBed& bed, Tier tier, const std::vector<Claim>& claims,
                             const std::vector<double>& velocities) {
  if (tier == Tier::correlation) return {};
  const bool slice = tier == Tier::one_dimensional;
  const std::vector<RunSpec>& available = slice ? bed.one_dimensional : bed.three_dimensional;
  const std::vector<double>& wanted = velocities.empty() && slice ? bed.usual_velocities : velocities;
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
  std::vector<double> known;
  for (const RunSpec& run : available) known.push_back(run.superficial_velocity);
  for (const double velocity : wanted)
    if (std::ranges::none_of(known, [&](double one) { return near(one, velocity); }))
      throw std::invalid_argument(
          fmt::format("no run at {} m/s; allowed are {} m/s", velocity, fmt::join(known, ", ")));
  std::vector<RunSpec> runs;
  for (const RunSpec& run : available) {
    const bool at_velocity = wanted.empty() || std::ranges::any_of(wanted, [&](double velocity) {
                               return near(velocity, run.superficial_velocity);
                             });
    if (at_velocity && std::ranges::any_of(claims, [&](const Claim& claim) { return asks_for(claim, run); }))
      runs.push_back(run);
  }
  if (runs.empty())
    throw std::invalid_argument(fmt::format("none of the chosen claims is measured in a run at {} m/s",
                                            fmt::join(wanted.empty() ? known : wanted, ", ")));
  return runs;
}

CampaignOutcome simulate(const ComparisonBed& bed, std::vector<Candidate>& candidates, const std::vector<RunSpec>& runs,
                         const CampaignOptions& options) {
  std::vector<NamedScene> scenes;
  for (const Candidate& candidate : candidates)
    for (const RunSpec& run : runs)
      scenes.push_back({fmt::format("{} {}", candidate.name, run_key(run)), load_run_scene(with(run, candidate))});
  const CampaignOutcome outcome = run_scenes(scenes, options);
  auto next = scenes.begin();
  for (Candidate& candidate : candidates) {
    std::vector<FinishedRun> finished;
    for (const RunSpec& run : runs) {
      Scene scene = (next++)->scene;
      const std::string hash = scene_hash(scene);
      if (!std::filesystem::exists(result_file(options.out, hash))) continue;
      finished.push_back({run, std::move(scene), load_own_result(options.out, hash), false, false});
      candidate.core_seconds += finished.back().result.cpu_seconds;
      candidate.simulated_seconds += finished.back().result.simulated_seconds;
    }
    candidate.runs = finished.size();
    for (const auto& [key, measurement] : measure_runs(finished, bed.measuring))
      candidate.measurements[key] = measurement;
  }
  return outcome;
}

void evaluate_candidates(std::vector<Candidate>& candidates, const std::vector<Claim>& claims) {
  for (Candidate& candidate : candidates) candidate.evaluations = evaluate(claims, candidate.measurements);
}

std::string_view to_string(Change change) {
  switch (change) {
    case Change::better:
      return "better";
    case Change::worse:
      return "worse";
    case Change::same:
      return "same";
    case Change::undecided:
      return "undecided";
  }
  throw std::logic_error("to_string: unknown change");
}

Change change(const Evaluation& first, const Evaluation& other) {
  if (!first.ours || !other.ours) return Change::undecided;
  const StatementKind kind = first.claim.kind;
  if (kind == StatementKind::increasing || kind == StatementKind::decreasing) {
    const int step = rank(other.verdict) - rank(first.verdict);
    return step > 0 ? Change::better : step < 0 ? Change::worse : Change::same;
  }
  if (!first.interval || !other.interval) return Change::undecided;
  const auto half_width = [](const Evaluation& evaluation) {
    return 0.5 * (evaluation.interval->second - evaluation.interval->first);
  };
  const double nearer = distance(first.claim, *first.ours) - distance(first.claim, *other.ours);
  if (std::abs(nearer) <= std::hypot(half_width(first), half_width(other))) return Change::same;
  return nearer > 0.0 ? Change::better : Change::worse;
}

std::map<Change, std::size_t> count_changes(const Candidate& first, const Candidate& other) {
  std::map<Change, std::size_t> counts;
  for (std::size_t k = 0; k < other.evaluations.size(); ++k)
    if (other.evaluations[k].ours) ++counts[change(first.evaluations[k], other.evaluations[k])];
  return counts;
}

bool answered(const std::vector<Candidate>& candidates, std::size_t claim) {
  return std::ranges::any_of(candidates,
                             [&](const Candidate& candidate) { return candidate.evaluations[claim].ours.has_value(); });
}

}  // namespace slfb::compare
