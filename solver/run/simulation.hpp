#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "solver/io/run_result.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {

struct Progress {
  std::string stage;
  double simulated_seconds = 0.0;
  double planned_seconds = 0.0;  ///< for drops an estimate from the spheres that have arrived
  double wall_seconds = 0.0;
  double particle_steps_per_second = 0.0;
};

struct RunOptions {
  int threads = 1;
  std::filesystem::path directory;  ///< of checkpoint.h5, failure.h5 and snapshots; created if missing
  std::function<void(const Progress&)> progress;
  double progress_interval = 0.2;           ///< wall-clock time between calls of `progress` [s]
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
/// std::runtime_error tells what, where and when.
RunOutcome run_scene(const Scene& scene, const RunOptions& options);

/// Removes what run_scene has left in its directory for a continuation or after a failure.
void remove_checkpoints(const std::filesystem::path& directory);

}  // namespace slfb
