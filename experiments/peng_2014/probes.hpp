#pragma once

#include "experiments/quantities/measurement.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {

/// What the solver makes of a scene's constants in cases so small that the answer is sharp: each is a moment of
/// computing without chance, so that its gate can be narrow. Keys:
///
/// restitution/solver: two bed spheres meet head-on at 0.1 m/s, speed after over speed before [-];
/// sliding_friction/solver: a bed sphere slides over the floor at 0.2 m/s, its deceleration over g [-];
/// terminal_velocity/solver: one bed sphere settles in the scene's liquid at rest [m/s];
/// frozen_bed_gradient/solver: pressure gradient, static head removed, that the one-dimensional liquid has at 0.05 m/s
/// in bed spheres held on a cubic lattice of 1.2 diameters [Pa/m].
Measurements measure_probes(const Scene& scene);

/// Of the working scene of the central case, experiments/peng_2014/scenes/6in5W.toml.
Measurements measure_probes();

}  // namespace slfb
