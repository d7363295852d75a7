#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "solver/dem/particles.hpp"
#include "solver/fluid/column_grid.hpp"

/// Snapshots for ParaView 5.10 and later (VTKHDF 1.0, the version that VTK 9.1 reads).
namespace slfb::io {

/// Spheres as an unstructured grid of points: radius, diameter, velocity, angular velocity and species. The time
/// [s] is the attribute `time_seconds`.
void write_particles_vtkhdf(const std::filesystem::path& file, const dem::Particles& particles, double time);

/// Liquid as an image whose points are the centres of the squares times the layers of the column: voidage, velocity
/// and pressure; across a single square or layer both its ends. A square whose centre lies outside the column holds
/// NaN. Fields are indexed as in ColumnGrid; `cell_velocity` is the velocity at the cell centres [m/s], `pressure` in
/// Pa.
void write_liquid_vtkhdf(const std::filesystem::path& file, const fluid::ColumnGrid& grid,
                         const std::vector<double>& voidage, const std::array<std::vector<double>, 3>& cell_velocity,
                         const std::vector<double>& pressure, double time);

}  // namespace slfb::io
