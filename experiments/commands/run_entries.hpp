#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/runs/campaign.hpp"

namespace slfb {

/// One run of a profile with what a scheduler needs to know of it.
struct RunEntry {
  RunSpec spec;
  std::string key;            ///< names it in the profile (run_key)
  std::string hash;           ///< names its result
  double core_seconds = 0.0;  ///< estimate of what it costs on one core
  bool done = false;          ///< its result lies in `out`
  bool needed = true;         ///< not done, nor committed where the profile goes on from committed results
};

/// All runs of a profile, each result once. \param out folder of runs/
std::vector<RunEntry> run_entries(const Profile& profile, const std::filesystem::path& out);

/// The run of a profile with this key or hash. Throws std::invalid_argument that names the nearest keys.
RunSpec find_run(const Profile& profile, const std::string& key_or_hash);

/// {"key", "hash", "profile", "scene", "overrides", "estimated_core_seconds", "result", "done", "needed"}; the scene is
/// the file that the overrides change.
nlohmann::ordered_json run_entry_json(const RunEntry& entry, const std::filesystem::path& out);

}  // namespace slfb
