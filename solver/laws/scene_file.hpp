#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_problems.hpp"

namespace slfb {

/// Texts "key=value" of the command line; the key is the dotted path in the scene file, e.g. "contact.stiffness=1e3
/// N/m", "stage[2].repetitions=5" or "species[0].density=2300 kg/m3".
using Overrides = std::vector<std::string>;

/// Reads, converts to SI and checks a scene. Throws SceneError before anything runs.
Scene load_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same from text; `origin` takes the place of the file name in messages.
Scene parse_scene(const std::string& text, const std::string& origin, const Overrides& overrides = {});

/// The same from the scene_text of a result: a key that it does not have means what it meant before there was a choice.
Scene parse_archived_scene(const std::string& text, const std::string& origin);

/// The same checks of a scene that was made or changed in memory. Throws SceneError, without lines of a file.
void validate_scene(const Scene& scene);

/// Every value, defaults included, in SI and in fixed order: what the hash is taken of. Read back with parse_scene it
/// is the same scene. Not written are keys of other contact laws, and newer keys while they have their defaults
/// (`left_out_if_default` in solver/scene/scene_description.hpp).
std::string canonical_toml(const Scene& scene);

/// Sixteen hexadecimal digits (XXH3, 64 bit) of canonical_toml and the numerics version, without what changes no
/// result: title, checkpoint interval, permission for a large step, and without keys of the only value that there was
/// when runs were first named (`left_out_of_name_if`). A law from a file counts by its text. Throws
/// UserLawError if that file cannot be read.
std::string scene_hash(const Scene& scene);

/// A-priori bound of the DEM step: 1/ω_0 = √(m_eff/k_n), the least of all pairs that can meet (walls count as infinite
/// mass) [s]. Where k_n depends on the overlap it is that at a hundredth of the effective radius. Infinite for a scene
/// without spheres. Throws UserLawError, and std::invalid_argument for an unknown contact law.
double contact_time_step_bound(const Scene& scene);

}  // namespace slfb
