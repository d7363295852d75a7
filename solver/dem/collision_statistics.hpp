#pragma once

#include <cstdint>

namespace slfb::dem {

/// One finished contact of two spheres, from the first step with overlap to the last.
struct Collision {
  std::uint32_t first, second;  ///< numbers of the spheres, first < second
  std::int64_t end_step;        ///< number of the last step of the engine with overlap
  std::uint32_t steps;          ///< steps with overlap: the duration over the time step [-]
  double impact_speed;          ///< normal approach speed in the first of them [m/s]
};

}  // namespace slfb::dem
