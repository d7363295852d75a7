#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/dem/particles.hpp"
#include "solver/fluid/column_grid.hpp"

/// Snapshots for ParaView 5.11 and later (VTKHDF 1.0, the version that VTK 9.1 reads). ParaView 5.11 knows them by the
/// ending .hdf, and a list of them with their times by .hdf.series.
namespace slfb::io {

/// The file of a snapshot: KIND_TIME.hdf, the time in microseconds. \param time [s]
std::filesystem::path snapshot_file(const std::filesystem::path& folder, const std::string& kind, double time);

/// Writes KIND.hdf.series, the list of all snapshots of a kind in a folder with their times, which ParaView opens as
/// one. Throws std::runtime_error that names the file if it cannot be written.
void write_snapshot_series(const std::filesystem::path& folder, const std::string& kind);

/// Spheres as an unstructured grid of points with radius and diameter [m], velocity [m/s], angular velocity [rad/s] and
/// species (index into Scene::species), in single precision. `time` [s] is the attribute `time_seconds`. Throws
/// std::runtime_error that names the file if it cannot be written.
void write_particles_vtkhdf(const std::filesystem::path& file, const dem::Particles& particles, double time);

/// Liquid as an image with voidage [-], velocity [m/s] and pressure [Pa], in single precision.
///
/// The points of the image are the centres of the squares times the layers of the column; across a single square or
/// layer they are its two ends, with the same values. A square whose centre lies outside the column holds NaN.
/// \param voidage, pressure, cell_velocity one value per cell, in the order of ColumnGrid: grid.size() values each
/// \param time [s], as for the spheres
/// \throws std::runtime_error that names the file if it cannot be written
void write_liquid_vtkhdf(const std::filesystem::path& file, const fluid::ColumnGrid& grid,
                         const std::vector<double>& voidage, const std::array<std::vector<double>, 3>& cell_velocity,
                         const std::vector<double>& pressure, double time);

}  // namespace slfb::io
