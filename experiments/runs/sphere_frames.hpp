#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include "solver/dem/particles.hpp"

/// Positions of spheres at times, as other codes write them.
namespace slfb {

/// The spheres at one instant; all vectors have the same length or, where the file does not have them, none.
struct SphereFrame {
  double time = 0.0;  ///< [s]
  std::vector<std::int64_t> id, type;
  dem::VectorField position;   ///< [m]
  dem::VectorField velocity;   ///< [m/s]
  std::vector<double> radius;  ///< [m]

  [[nodiscard]] std::size_t size() const { return position.z.size(); }
};

/// What a dump does not say of itself.
struct DumpUnits {
  double time_step = std::numeric_limits<double>::quiet_NaN();  ///< of its ITEM: TIMESTEP [s]; times are NaN without
  double length = 1.0;                                          ///< of one of its units of length [m]
  double velocity = 1.0;                                        ///< of one of its units of velocity [m/s]
};

/// Reads a file frame by frame, in its order, and hands each to `visit`. The frame is overwritten by the next one.
///
/// A file that begins with "ITEM: TIMESTEP" is a text dump of LIGGGHTS or LAMMPS: of the columns of its ITEM: ATOMS,
/// `x y z` (or unwrapped `xu yu zu`), `id`, `type`, `radius` or `diameter` and `vx vy vz` are read and others are left
/// out. Any other file is a CSV (series_file.hpp) with the columns time, x, y, z and, where known, id, type, diameter,
/// vx, vy, vz; lines of one time are one frame.
/// \throws std::runtime_error with file, line and column on anything unexpected, also where times go back.
void for_each_frame(const std::filesystem::path& file, const DumpUnits& units,
                    const std::function<void(const SphereFrame&)>& visit);

}  // namespace slfb
