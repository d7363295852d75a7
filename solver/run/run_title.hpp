#pragma once

#include <string>

#include "solver/laws/scene_file.hpp"

namespace slfb::simulation {

/// How warnings call a run: by the title of its scene, or, without one, by the folder that its result lies in.
inline std::string run_title(const Scene& scene) {
  return scene.title.empty() ? "run " + scene_hash(scene) : scene.title;
}

}  // namespace slfb::simulation
