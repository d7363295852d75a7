#pragma once

#include <string>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_problems.hpp"

namespace slfb::description {

/// Shortest decimal that reads back as the same number.
std::string shortest(double value);

/// Ranges first, then, once all values make sense on their own, the physics between them. Throws SceneError.
void check_scene(const Scene& scene, Problems& problems);

}  // namespace slfb::description
