#pragma once

#include <filesystem>
#include <string>

#include "experiments/runs/campaign.hpp"

/// Where the scenes of a profile come from and where their results lie.
namespace slfb {

/// The scene of a specification with its overrides.
Scene load_run_scene(const RunSpec& spec);

/// Folder of one run: checkpoint, snapshots, scene.toml and, once finished, result.h5.
std::filesystem::path run_directory(const std::filesystem::path& out, const std::string& hash);

/// The result of a finished run.
std::filesystem::path result_file(const std::filesystem::path& out, const std::string& hash);

/// Reads it. Throws std::runtime_error with the way out where it is damaged.
RunResult load_own_result(const std::filesystem::path& out, const std::string& hash);

/// The committed result of a specification: PROFILE/SYSTEM_0.06_VARIANT.h5 in its folder `published`, "default" for no
/// variant, with "_seed-2" behind it for a replicate.
std::filesystem::path published_file(const RunSpec& spec);

/// What was measured in it, from the whole series: the same name with .json.
std::filesystem::path published_summary(const RunSpec& spec);

/// Puts a finished result where it can be committed: its summary, and its series thinned to what figures draw, the bed
/// at every fifth sample and drops at every twentieth; replicates, of which figures draw means alone, five times more.
/// With `whole` the first drop stays as it was recorded, and the snapshots stay. `rules` as for summarise.
void publish_result(const RunSpec& spec, const RunResult& result, bool whole, const MeasuringRules& rules);

}  // namespace slfb
