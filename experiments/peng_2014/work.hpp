#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/work/work.hpp"

/// Peng et al. (2014), Chem. Eng. Sci., doi 10.1016/j.ces.2014.04.040: forces on a single sphere that is introduced
/// into a solid-liquid fluidised bed.
namespace slfb {

/// The work, put together once.
const Work& peng_2014_work();

/// Its claims, and its profiles by name.
std::vector<Claim> load_claims();
Profile load_profile(const std::string& name);

/// What its default scene is called as a reading (readings.toml).
inline constexpr const char* default_reading = "kt-0.01_by-gradient_own-spread_springs-1e4";

/// The runs with the paper's springs (profile full) in `out`/runs or committed, for the figures of contacts and
/// single forces.
std::vector<FinishedRun> runs_with_own_springs(const std::filesystem::path& out);

}  // namespace slfb
