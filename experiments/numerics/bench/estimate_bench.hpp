#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/laws/scene_file.hpp"

/// How far the estimate before a run is from what it takes on this machine, part by part.
namespace slfb::bench {

/// A small bed in which one part of the solver has most of the work.
struct EstimatePart {
  std::string name, description;
  Overrides overrides;  ///< of experiments/numerics/studies/scenes/box.toml
};

/// Those of estimate_parts.toml. \throws std::runtime_error with file, line and key
std::vector<EstimatePart> estimate_parts();

struct EstimateTiming {
  double measured = 0.0, estimated = 0.0;  ///< CPU time of the run [s]
  [[nodiscard]] double ratio() const { return measured / estimated; }
};

/// Runs the scene of a part with one thread, `repetitions` times, and takes the least CPU time; its files lie in
/// `folder` meanwhile. \throws std::runtime_error when the solver breaks down, SceneError for wrong overrides
EstimateTiming time_estimate(const EstimatePart& part, int repetitions, const std::filesystem::path& folder);

}  // namespace slfb::bench
