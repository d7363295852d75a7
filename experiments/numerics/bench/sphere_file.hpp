#pragma once

#include <filesystem>

#include "solver/dem/particles.hpp"

namespace slfb::bench {

/// Keeps the spheres from which a measurement starts (HDF5: positions, velocities, angular velocities, radii, masses,
/// added masses [SI], species), so that they are computed once. Throws std::runtime_error naming the file when it
/// cannot be written.
void save_spheres(const std::filesystem::path& file, const dem::Particles& particles);
/// What save_spheres wrote. Throws std::runtime_error naming the file when it cannot be read.
dem::Particles load_spheres(const std::filesystem::path& file);

}  // namespace slfb::bench
