#pragma once

#include <string>
#include <string_view>

#include "solver/scene/scene.hpp"
#include "solver/scene/scene_problems.hpp"

namespace slfb::description {

/// Whether a key must be there, may be there, or has no meaning beside the values read before it.
struct Presence {
  enum class Rule { required, optional, meaningless } rule;
  std::string reason;             ///< why it has no meaning: "it belongs to shape = \"box\""
  bool left_out = false;          ///< of the canonical text, and so of the hash
  bool left_out_of_name = false;  ///< of the hash alone
};
inline const Presence required{Presence::Rule::required, {}};
inline const Presence optional{Presence::Rule::optional, {}};

/// What reading, checking and naming a scene asks of the laws that it names. A scene knows no law: solver/laws answers.
struct SceneLaws {
  /// Whether the contact law `law` takes the key of [contact]; `optional` for a law that is not known.
  Presence (*contact_key)(const std::string& law, std::string_view key);
  /// Adds what is wrong with contact.law and with contact.time_step under that law. The scene is in range.
  void (*check_contact)(const Scene& scene, Problems& problems);
  /// Adds what keeps the spheres from finding places at the start. The scene has passed all other checks.
  void (*check_start)(const Scene& scene, Problems& problems);
  /// Adds what is wrong with coupling.drag_law.
  void (*check_drag_law)(const Scene& scene, Problems& problems);
  /// Where a law from a file lies that a scene file names: beside `scene_file`, if it does, else as written.
  std::string (*place)(const std::string& law, const std::string& scene_file);
  /// What the hash of a scene has of a law: its name, or the hash of the file that it comes from.
  std::string (*identity)(const std::string& law);
};

}  // namespace slfb::description
