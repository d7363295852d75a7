#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "solver/io/run_result.hpp"
#include "solver/run/progress.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {

struct RunOptions {
  int threads = 1;                  ///< of this run; the result does not depend on it
  std::filesystem::path directory;  ///< of checkpoint, failure.h5 and snapshots; created if missing
  std::function<void(const Progress&)> progress = {};
  double progress_interval = 0.2;           ///< wall-clock time between calls of `progress` [s]
  std::function<void()> started = {};       ///< called when all is set up: from now on a stop saves the state
  const std::atomic<bool>* stop = nullptr;  ///< set from outside to end after the present liquid step
};

enum class RunStatus { finished, interrupted };

struct RunOutcome {
  RunStatus status = RunStatus::finished;
  RunResult result;
};

/// Runs all stages of a scene and returns what was recorded.
///
/// Resumes from directory/checkpoint.h5 if that belongs to the same scene and numerics version, with bitwise the same
/// continuation. Writes checkpoints on the way and when stopped; the last one stays, so that nothing is lost before the
/// result is saved. When the motion or the liquid breaks down, the state is saved to directory/failure.h5 and a
/// std::runtime_error tells what, where and when. Throws SceneError if the bed does not fit into the column, and
/// std::runtime_error if a file cannot be written or the checkpoint cannot be read.
RunOutcome run_scene(const Scene& scene, const RunOptions& options);

/// Removes what run_scene has left in its directory for a continuation or after a failure.
void remove_checkpoints(const std::filesystem::path& directory);

}  // namespace slfb
