#pragma once

#include <cstdint>

#include "solver/scene/scene.hpp"

/// How long the liquid alone takes, on meshes of several sizes.
namespace slfb::bench {

struct FluidTiming {
  int threads = 1;
  std::size_t cells = 0;
  std::int64_t steps = 0;
  double seconds = 0.0, momentum = 0.0, pressure = 0.0;  ///< wall time of all steps [s]
  double iterations_per_step = 0.0;                      ///< of the pressure equation [-]
  double continuity_error = 0.0;                         ///< of the last step, over the inlet's volume flow [-]
  [[nodiscard]] double nanoseconds_per_cell_step() const {
    return 1e9 * seconds / (static_cast<double>(steps) * static_cast<double>(cells));
  }
};

/// Liquid of the scene in a frozen bed that fills the lower half at voidage 0.6, uneven by ±0.15 from cell to cell and
/// from step to step as a coupled bed is, with the drag of 5 mm spheres. Ten steps are made before the clock starts.
/// \throws std::runtime_error when the liquid solver breaks down
FluidTiming time_fluid(const Scene& scene, int threads, std::int64_t steps);

}  // namespace slfb::bench
