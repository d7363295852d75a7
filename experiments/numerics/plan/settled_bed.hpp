#pragma once

#include "solver/scene/scene.hpp"

/// The packing that a scene starts from, found by letting a part of its bed settle.
namespace slfb::plan {

struct SettledBed {
  double voidage = 0.0;     ///< of the packing, by its centre of mass [-]
  double half_width = 0.0;  ///< of the 95 % interval over the beds [-]
  int beds = 0;             ///< that settled, with other seeds
  double spheres = 0.0;     ///< of each
};

/// Three beds of some hundred of the scene's spheres settle in its column, which is as much lower, as its first stage
/// says: friction, walls, start and liquid make a packing of 0.37 to 0.54, and the minimum fluidisation velocity goes
/// with about the fourth power of that. Takes seconds.
/// \throws std::invalid_argument for a scene without a bed; SceneError, or what run_scene throws
SettledBed settle(const Scene& scene);

/// The voidage of the settled bed at which the liquid lifts it: superficial velocity by the drag law of the scene
/// [m/s].
double minimum_fluidisation_velocity(const Scene& scene, double packed_voidage);

}  // namespace slfb::plan
