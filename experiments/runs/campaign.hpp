#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/quantities/measure_key.hpp"
#include "experiments/quantities/run_summary.hpp"
#include "solver/io/run_result.hpp"
#include "solver/laws/scene_file.hpp"

namespace slfb {

/// One simulation that figures share: a scene file and what a profile changes in it.
struct RunSpec {
  std::string system;           ///< of the work: "6mm-in-5mm"
  double superficial_velocity;  ///< U_L [m/s]
  std::string variant;          ///< "" for the default drag law of the profile, else what differs ("di-felice-1994")
  std::filesystem::path scene;
  Overrides overrides;
  std::string profile = {};                   ///< that it belongs to: "quick"
  std::vector<std::string> differences = {};  ///< Profile::differences of that profile
  std::filesystem::path published = {};       ///< folder of the committed results of its work; empty: there are none
  std::optional<std::uint64_t> seed = {};     ///< of a replicate; empty: that of the scene
  std::filesystem::path system_scene = {};    ///< scene of its system, where the run is of another one
};

/// Names what runs answer: "system/U_L" or "system/U_L/variant", U_L as velocity_text has it.
std::string run_key(std::string_view system, double superficial_velocity, std::string_view variant = "");

/// Names one run in lists of needed runs and on pages: the same, with "/seed-2" behind it for a replicate.
std::string run_key(const RunSpec& spec);

/// The runs of a profile ("quick", "full") and what sets it apart from the work that it reproduces.
struct Profile {
  std::string name;
  std::vector<std::string> differences;  ///< sentences, shown on each figure
  std::vector<RunSpec> runs;
  std::set<std::string> whole = {};     ///< run_key of those that figures draw sample by sample: published unthinned
  bool goes_on_from_published = false;  ///< what is published and up to date is not simulated again
};

/// A finished run with the specification it answers.
struct FinishedRun {
  RunSpec spec;
  Scene scene;
  RunResult result;
  bool published = false;                  ///< read from the committed results rather than from this machine
  bool stale = false;                      ///< made by an older numerics version
  std::optional<RunSummary> summary = {};  ///< of the whole series, where `result` holds thinned ones
};

/// Finished runs of a profile: first this machine's (`out`/runs), then the committed ones (RunSpec::published).
std::vector<FinishedRun> finished_runs(const Profile& profile, const std::filesystem::path& out);

/// Those of `runs` that this machine made for the profile.
std::vector<FinishedRun> own_runs(std::vector<FinishedRun> runs, const std::string& profile);

/// The committed runs of a profile alone, those of an older numerics version left out: what a machine's own have to
/// agree with.
std::vector<FinishedRun> published_runs(const Profile& profile);

}  // namespace slfb
