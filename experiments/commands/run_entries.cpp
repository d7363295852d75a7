#include "experiments/commands/run_entries.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <stdexcept>

#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/support/close_names.hpp"

namespace slfb {

std::vector<RunEntry> run_entries(const Profile& profile, const std::filesystem::path& out) {
  std::set<std::string> committed, hashes;
  if (profile.goes_on_from_published)
    for (const FinishedRun& run : published_runs(profile)) committed.insert(run_key(run.spec));
  std::vector<RunEntry> entries;
  for (const RunSpec& spec : profile.runs) {
    const Scene scene = load_run_scene(spec);
    RunEntry entry{spec, run_key(spec), scene_hash(scene), estimate_run(scene).core_seconds};
    if (!hashes.insert(entry.hash).second) continue;
    entry.done = std::filesystem::exists(result_file(out, entry.hash));
    entry.needed = !entry.done && !committed.contains(entry.key);
    entries.push_back(std::move(entry));
  }
  return entries;
}

RunSpec find_run(const Profile& profile, const std::string& key_or_hash) {
  std::vector<std::string> keys;
  for (const RunSpec& spec : profile.runs) {
    keys.push_back(run_key(spec));
    if (keys.back() == key_or_hash) return spec;
  }
  for (const RunSpec& spec : profile.runs)
    if (scene_hash(load_run_scene(spec)) == key_or_hash) return spec;
  throw std::invalid_argument(fmt::format("profile {} has no run \"{}\"; close: {} (`slfb list --runs {}` shows all)",
                                          profile.name, key_or_hash, fmt::join(close_names(key_or_hash, keys), ", "),
                                          profile.name));
}

nlohmann::ordered_json run_entry_json(const RunEntry& entry, const std::filesystem::path& out) {
  return {{"key", entry.key},
          {"hash", entry.hash},
          {"profile", entry.spec.profile},
          {"scene", entry.spec.scene.string()},
          {"overrides", entry.spec.overrides},
          {"estimated_core_seconds", entry.core_seconds},
          {"result", result_file(out, entry.hash).string()},
          {"done", entry.done},
          {"needed", entry.needed}};
}

}  // namespace slfb
