#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_laws.hpp"

/// The text of a scene, read and written by walking the description. Who uses scenes calls solver/laws/scene_file.hpp,
/// which hands over the laws of the suite.
namespace slfb::description {

/// Reads, converts to SI and checks. `origin` stands for the file in errors. Throws SceneError.
/// \param unwritten values of the keys that the text does not have
Scene read_scene(const std::string& text, const std::string& origin, const std::vector<std::string>& overrides,
                 const SceneLaws& laws, const Scene& unwritten = {});

/// See canonical_toml() and scene_hash().
std::string canonical_text(const Scene& scene, const SceneLaws& laws);
std::string hash_of(const Scene& scene, const SceneLaws& laws);

}  // namespace slfb::description
