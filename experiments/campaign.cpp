#include "experiments/campaign.hpp"

#include <spdlog/spdlog.h>

#include <stdexcept>

#include "experiments/run_files.hpp"

namespace slfb {

std::vector<FinishedRun> finished_runs(const Profile& profile, const std::filesystem::path& out) {
  std::vector<FinishedRun> runs;
  for (const RunSpec& spec : profile.runs) {
    Scene scene = load_run_scene(spec);
    const std::string hash = scene_hash(scene);
    if (const auto own = result_file(out, hash); std::filesystem::exists(own)) {
      runs.push_back({spec, std::move(scene), load_result(own), false, false, {}});
    } else if (const auto committed = published_file(spec); std::filesystem::exists(committed)) {
      RunResult result;
      try {
        result = load_result(committed);
      } catch (const std::runtime_error& error) {
        // Written by an earlier version of the suite, it may lack what this one reads.
        spdlog::warn("left out a published result: {}", error.what());
        continue;
      }
      const bool stale = result.numerics != numerics_version || result.name != hash;
      // An older result is analysed with the scene it was made from.
      if (stale) scene = parse_scene(result.scene_text, committed.string());
      std::optional<RunSummary> summary;
      if (const auto numbers = published_summary(spec); std::filesystem::exists(numbers))
        summary = load_summary(numbers);
      runs.push_back({spec, std::move(scene), std::move(result), true, stale, std::move(summary)});
    }
  }
  return runs;
}

}  // namespace slfb
