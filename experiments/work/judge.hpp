#pragma once

#include <filesystem>
#include <vector>

#include "experiments/work/profiles.hpp"
#include "experiments/work/work.hpp"

/// What our laws and simulations say to the claims of a work.
namespace slfb {

/// What claims and figures are held against: all that needs no run, these runs, and what depends on the contact
/// stiffness from runs with that of the scene, in `out`/runs or committed.
Measurements measure_all(const Work& work, const std::vector<FinishedRun>& runs, const std::filesystem::path& out);

/// A profile with its finished runs, what was measured in them, and what that says to the claims.
struct Judgement {
  Profile profile;
  Profile shown;                  ///< with_shown_runs
  std::vector<FinishedRun> runs;  ///< finished ones of `shown`, of one model for each key
  Measurements measurements;
  std::vector<Evaluation> evaluations;     ///< in the order of the claims
  std::vector<FinishedRun> left_out = {};  ///< runs of another model (take_out_other_models)
};

/// The sequence that `slfb check` and `slfb figures` share: finished runs, measurements, verdicts, causes, and the
/// gates of this machine's runs of the profile against the published ones. \param claims those to be judged \param out
/// folder of runs/
Judgement judge(const Work& work, const Profile& profile, const std::vector<Claim>& claims,
                const std::filesystem::path& out);

}  // namespace slfb
