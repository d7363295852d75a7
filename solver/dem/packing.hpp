#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace slfb::dem {

struct PlacedSphere {
  std::array<double, 3> centre;  ///< [m]
  int species;                   ///< index into Scene::species
};

/// Positions of all bed particles at the start, as start.arrangement says; species shuffled, no overlap.
///
/// - lattice: a jittered cubic lattice, filled from the bottom, with places for the largest spheres; where these are
///   too few, several spheres of a smaller size share one;
/// - random: random sequential addition over the whole column (Widom 1966, J. Chem. Phys. 44:3888): each sphere is put
///   at a place that is uniform over the column, and put anew until it overlaps none of those before it, the largest
///   spheres first. In a wide column this ends near a solids fraction of 0.35;
/// - random_close: the same in the lower part of the column, at a solids fraction of 0.30, or less where walls leave
///   too little room.
///
/// Random numbers come from a counter-based generator on integers (Philox, Random123) and are used without functions
/// that differ between machines, so the start is the same on any of them.
/// Throws SceneError, with how many spheres found a place, if they do not fit below the top of the column.
std::vector<PlacedSphere> start_positions(const Scene& scene);

/// Why the spheres of a checked scene do not find places at the start; empty if they do, as also of more than ten
/// million spheres, which are not placed for that. Costs little where there is much room.
std::string start_problem(const Scene& scene);

}  // namespace slfb::dem
