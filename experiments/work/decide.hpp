#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/work/judge.hpp"
#include "experiments/work/more_runs.hpp"

/// More drops, beds or time where a claim is not decided, the cheapest first.
///
/// The claims are judged, the cheapest step that could decide one of them is simulated, and they are judged again,
/// until none is left that more runs could decide, or the budget is spent. A step makes at most as many runs again as
/// there are, so that looks are few; later looks have wider intervals (significance_of_look), so that looking again
/// does not make wrong verdicts likelier.
namespace slfb {

/// What could decide a claim next.
struct NextStep {
  std::vector<MoreRun> again;       ///< runs once more, with other seeds
  std::vector<RunSpec> specs = {};  ///< their specifications, and those of the profile that do not exist yet
  double core_seconds = 0.0;
  std::optional<double> core_seconds_to_decide = {};  ///< of all steps, were means and scatter what they seem to be
  std::string none = {};                              ///< why no run would help; empty where one would
};

/// What the loop needs of the world, so that it can be tested without one.
struct DecideWorld {
  std::function<std::vector<Evaluation>(const MoreRuns&)> judge;
  std::function<NextStep(const Evaluation&)> next_step;  ///< by what the judgement saw
  /// Simulates; returns the CPU time spent [s], or nothing when it was interrupted.
  std::function<std::optional<double>(const std::vector<RunSpec>&)> simulate;
  /// Whether a claim rests on any of these runs.
  std::function<bool(const Claim&, const std::vector<RunSpec>&)> rests_on;
  std::function<void(const MoreRuns&)> save;                           ///< after each step
  std::function<void(const Evaluation&, const NextStep&)> begin = {};  ///< before each step
};

struct DecideOutcome {
  std::vector<Evaluation> evaluations;  ///< of all claims, at the end
  std::vector<NextStep> next;           ///< of each, what would come next; empty for the decided ones
  MoreRuns more;
  double core_seconds = 0.0;  ///< spent
  int steps = 0;
  bool interrupted = false;
};

/// \param budget CPU time that may be spent [s]: a step that is expected to take more than what is left is not begun
DecideOutcome decide(const DecideWorld& world, MoreRuns more, double budget);

/// The runs that a number of a work hangs on, one of each velocity: those of `runs` with the seed of their scene.
/// Numbers at a voidage hang on the runs on either side of it; those of all systems on too many, and have none.
std::vector<RunSpec> runs_behind(const MeasureKey& measure, const std::vector<RunSpec>& runs, const Work& work,
                                 const Measurements& measurements);

/// The world of a work: its profile, its claims, this machine.
/// \param simulate as in DecideWorld
DecideWorld world_of(const Work& work, const Profile& profile, const std::vector<Claim>& claims,
                     const std::filesystem::path& out,
                     std::function<std::optional<double>(const std::vector<RunSpec>&)> simulate);

/// A table: what was decided, and for each undecided claim what it lacks and what that would cost.
std::string decide_text(const DecideOutcome& outcome);

}  // namespace slfb
