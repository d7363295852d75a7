#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solver/scene/scene_laws.hpp"

/// Changes of single values of a scene file, as the command line has them.
namespace slfb::description {

/// "key=value" in its parts.
struct Override {
  struct PathSegment {
    std::string key;
    std::optional<std::size_t> index;  ///< of stage[2]
  };
  std::string text;  ///< "key=value"
  std::string path;  ///< "stage[2].repetitions"
  std::vector<PathSegment> segments;
  std::string value;
  [[nodiscard]] std::string place() const { return "--set " + text; }
};

/// Throws SceneError for a text that is not key=value with a dotted path.
std::vector<Override> split_overrides(const std::vector<std::string>& texts);

/// Puts the values into the parsed file. An override of contact.law removes the keys of the file that the law does not
/// take; count removes total_mass, and the other way round. Throws SceneError for a path that the scene does not have.
void apply_overrides(toml::table& root, const std::vector<Override>& changes, const SceneLaws& laws);

}  // namespace slfb::description
