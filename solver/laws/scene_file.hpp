#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_problems.hpp"

namespace slfb {

/// "key=value" of the command line; the key is the dotted path in the scene file, e.g. "contact.stiffness=1e3 N/m",
/// "stage[2].repetitions=5" or "species[0].density=2300 kg/m3".
using Overrides = std::vector<std::string>;

/// Reads, converts to SI and checks a scene. Throws SceneError before anything runs.
Scene load_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same from text; `origin` stands in for the file name in messages.
Scene parse_scene(const std::string& text, const std::string& origin, const Overrides& overrides = {});

/// Physical checks of a scene built or changed in memory; parse_scene calls it with the lines it knows.
void validate_scene(const Scene& scene);

/// Every value, defaults included, in SI and in fixed order: what the hash is taken of. Reading it back with
/// parse_scene gives the same scene.
std::string canonical_toml(const Scene& scene);

/// Sixteen hexadecimal digits (XXH3, 64 bit) of canonical_toml and the numerics version, without what changes no
/// result: title, checkpoint interval, permission for a large step.
std::string scene_hash(const Scene& scene);

/// A-priori bound of the DEM step: 1/ω_0 = √(m_eff/k_n) of the lightest pair (walls count as infinite mass) [s].
double contact_time_step_bound(const Scene& scene);

}  // namespace slfb
