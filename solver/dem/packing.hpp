#pragma once

#include <array>
#include <vector>

#include "solver/scene/scene.hpp"

namespace slfb::dem {

struct PlacedSphere {
  std::array<double, 3> centre;
  int species;
};

/// Loose random start of all bed particles: a jittered lattice filled from the bottom, species shuffled, no overlap.
///
/// The jitter comes from a counter-based generator on integers (Philox, Random123), so the packing is the same on any
/// machine. Throws SceneError if the spheres do not fit below the top of the column.
std::vector<PlacedSphere> loose_packing(const Scene& scene);

}  // namespace slfb::dem
