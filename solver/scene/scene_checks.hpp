#pragma once

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_laws.hpp"
#include "solver/scene/scene_problems.hpp"

namespace slfb::description {

/// Ranges first, then, once all values make sense on their own, the physics between them. Throws SceneError with what
/// is wrong, beside what `problems` holds already.
void check_scene(const Scene& scene, Problems& problems, const SceneLaws& laws);

}  // namespace slfb::description
