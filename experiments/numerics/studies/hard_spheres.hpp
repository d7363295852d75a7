#pragma once

#include <array>
#include <vector>

namespace slfb::void_fraction_study {

/// Centres of equal spheres that do not overlap in a periodic cube; lengths in diameters.
struct Assembly {
  double side = 0.0;
  std::vector<std::array<double, 3>> centres;  ///< from 0 to side
};

/// Random assembly: points thrown at random, then pairs pushed apart until none overlaps. The same on every machine.
/// \param solids fraction of the cube in spheres, at most 0.55 (far beyond it nothing comes apart) [-]
Assembly hard_spheres(int count, double solids, unsigned seed);

}  // namespace slfb::void_fraction_study
