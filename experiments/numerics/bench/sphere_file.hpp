#pragma once

#include <filesystem>

#include "solver/dem/particles.hpp"

namespace slfb::bench {

/// The start of a measurement, kept so that it is made once.
void save_spheres(const std::filesystem::path& file, const dem::Particles& particles);
dem::Particles load_spheres(const std::filesystem::path& file);

}  // namespace slfb::bench
