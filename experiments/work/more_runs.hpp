#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/runs/campaign.hpp"
#include "experiments/work/work.hpp"

/// Runs that were made beyond the profiles of a work because claims were not decided (decide.hpp), and how often each
/// claim has been looked at.
namespace slfb {

/// A run of a profile once more, with another seed.
struct MoreRun {
  std::string profile, system;
  double superficial_velocity = 0.0;  ///< [m/s]
  std::string variant;
  std::uint64_t seed = 0;
  Overrides overrides = {};  ///< a longer fluidisation
};

struct MoreRuns {
  std::vector<MoreRun> runs;
  Looks looks;
};

/// Where they are kept: of this machine in the folder of its runs, committed beside the published runs of the work.
std::filesystem::path more_runs_file(const std::filesystem::path& out, const Work& work);
std::filesystem::path published_more_runs_file(const Work& work);

/// Those of both files; each run once, the larger number of looks. Throws std::runtime_error that names a damaged file.
MoreRuns load_more_runs(const Work& work, const std::filesystem::path& out);

void save_more_runs(const MoreRuns& more, const std::filesystem::path& file);

/// The specification of a run once more. \param base that of the profile
RunSpec once_more(RunSpec base, const MoreRun& more);

/// A profile with the runs that were made beyond it; a bed that it has itself is not taken twice.
Profile with_more_runs(Profile profile, const MoreRuns& more);

}  // namespace slfb
