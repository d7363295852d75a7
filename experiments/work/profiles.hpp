#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/readings/choices.hpp"
#include "experiments/runs/campaign.hpp"
#include "experiments/work/work.hpp"

/// The simulations behind the figures of a work, from its profiles.toml (README.md says what stands in it).
namespace slfb {

/// Names of the profiles, in the order of the file; none where the work has no such file.
std::vector<std::string> profile_names(const Work& work);

/// Throws std::runtime_error with file, line and key; for an unknown name, or an unknown system or variant of a run, it
/// lists the known ones.
Profile load_profile(const Work& work, const std::string& name);

/// The choices that the source leaves open, from its readings.toml. Throws as readings::load_choices.
readings::Choices load_choices(const Work& work);

/// The profile and the runs of Work::shown_beside: what figures and claims use where results exist. Only the profile's
/// own runs are simulated with it.
Profile with_shown_runs(const Work& work, Profile profile);

/// Finished runs of Work::shown_beside with the contact stiffness of their scene file, which other profiles may soften;
/// those of an older numerics version are left out.
std::vector<FinishedRun> runs_with_scene_stiffness(const Work& work, const std::filesystem::path& out);

}  // namespace slfb
