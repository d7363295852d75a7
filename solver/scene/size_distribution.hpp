#pragma once

#include <toml++/toml.h>

#include <string>

namespace slfb::description {

/// Replaces each [[species]] that lists `diameters` by one species per diameter, NAME-1, NAME-2, …, in that order:
///
///     [[species]]
///     name = "glass"
///     density = "2230 kg/m3"
///     diameters = ["2.8 mm", "3.0 mm", "3.2 mm"]
///     counts = [200, 600, 200]                  # or: total_mass = "20 g", mass_fractions = [0.2, 0.6, 0.2]
///
/// `file` stands for the file in errors. Throws SceneError that names file, line and key for a list that is no list, is
/// empty or has another length, for fractions that are negative or do not add up to 1 within 0.1 %, and for keys that
/// do not go together.
void expand_size_distributions(toml::table& scene, const std::string& file);

}  // namespace slfb::description
