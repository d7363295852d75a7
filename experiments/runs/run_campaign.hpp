#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/runs/campaign.hpp"

namespace slfb {

struct CampaignOptions {
  std::filesystem::path out;  ///< runs go to out/runs/<hash>
  int jobs = 2;               ///< side by side; lowered where jobs × threads_per_run exceeds the cores
  int threads_per_run = 1;
  bool progress = true;
  std::string heading = "";  ///< of the display: "step 2 of 3, simulations"
  /// Told of each run whose result has been saved, by its place among those asked for; one call at a time.
  std::function<void(std::size_t)> finished = {};
};

/// How many runs of a campaign ended in which way.
struct CampaignOutcome {
  int finished = 0;
  int skipped = 0;  ///< their results existed
  int failed = 0;
  int interrupted = 0;                     ///< stopped with their state saved, or not begun
  std::vector<std::string> failures = {};  ///< "label: reason" of each that failed

  [[nodiscard]] int unfinished() const { return failed + interrupted; }
  /// 0, 1 when a run failed, 130 when interrupted (what a shell reports for Ctrl-C).
  [[nodiscard]] int exit_status() const { return interrupted > 0 ? 130 : failed > 0 ? 1 : 0; }
};

/// One simulation: a scene and what to call it on the screen.
struct NamedScene {
  std::string label;
  Scene scene;
};

/// Runs the scenes that have no result in out/runs yet, the longest first, and saves each result there. A run that
/// fails is reported and does not stop the others. After SIGINT or SIGTERM the state of each run is saved and the same
/// call goes on from there.
CampaignOutcome run_scenes(const std::vector<NamedScene>& scenes, const CampaignOptions& options);

/// The same for the runs of a profile.
CampaignOutcome run_campaign(const std::vector<RunSpec>& specs, const CampaignOptions& options);

}  // namespace slfb
