#pragma once

#include "experiments/figures/figure.hpp"

/// The figures of the paper and of the questions that it leaves open, each a folder with its code and README.
namespace slfb {

/// Table 1: conditions of the paper, those used here, and what does not add up.
namespace table1_conditions {
Figure figure();
}
/// Table 2: straight lines fitted to the fall through the window.
namespace table2_fitted_lines {
Figure figure();
}
/// Figure 1: the meshing template, and how far each void-fraction scheme is from exact overlap at what cost.
namespace fig01_void_fraction_schemes {
Figure figure();
}
/// Figure 2: the domain and our mesh.
namespace fig02_mesh {
Figure figure();
}
/// Figure 3: the rig of the settling experiments, drawn from the paper's description.
namespace fig03_settling_rig {
Figure figure();
}
/// Figure 4: the same column with particle image velocimetry.
namespace fig04_velocimetry_rig {
Figure figure();
}
/// Figure 5: pressure drop of the bed against the superficial velocity.
namespace fig05_pressure_drop {
Figure figure();
}
/// Figure 6: the bed at the end of the fall around minimum fluidisation.
namespace fig06_snapshots {
Figure figure();
}
/// Figure 7: height of the steel sphere against time around minimum fluidisation.
namespace fig07_heights {
Figure figure();
}
/// Figure 8: history of the steel sphere at U_L = 0.10 m/s.
namespace fig08_history {
Figure figure();
}
/// Figure 9: height of the steel sphere against time, and the straight lines through it.
namespace fig09_trajectories {
Figure figure();
}
/// Figure 10 and Table 2: classification velocity against the superficial velocity.
namespace fig10_classification_velocity {
Figure figure();
}
/// Figure 11: predicted against measured classification velocity.
namespace fig11_velocity_parity {
Figure figure();
}
/// Figure 12: fluctuation of the liquid's velocity against the voidage.
namespace fig12_liquid_fluctuation {
Figure figure();
}
/// Figure 13: void fraction in the plane y = 0.
namespace fig13_void_fraction {
Figure figure();
}
/// Figure 14: vorticity, speed and direction of the liquid in the plane y = 0.
namespace fig14_vorticity {
Figure figure();
}
/// Figure 15: the steel sphere on its way through 3 mm glass at three voidages.
namespace fig15_paths {
Figure figure();
}
/// Figure 16: mean and largest number of contacts of the steel sphere in 3 mm glass.
namespace fig16_contacts {
Figure figure();
}
/// Figure 17: contacts and velocity of the foreign sphere over a tenth of a second.
namespace fig17_collisions {
Figure figure();
}
/// Figure 18: fluctuating kinetic energy of the fluidised particles.
namespace fig18_fluctuating_energy {
Figure figure();
}
/// Figure 19: dimensionless collision frequency against the kinetic theory.
namespace fig19_dimensionless_frequency {
Figure figure();
}
/// Figure 20: collision frequency of the eight systems.
namespace fig20_collision_frequency {
Figure figure();
}
/// Figure 21: collision force in time at six voidages.
namespace fig21_force_history {
Figure figure();
}
/// Figure 22: drag and pressure-gradient force on the steel sphere.
namespace fig22_fluid_forces {
Figure figure();
}
/// Figure 23: collision force over drag.
namespace fig23_collision_to_drag {
Figure figure();
}
/// Figure 24: collision force against the voidage, and the correlation fitted to it.
namespace fig24_force_and_voidage {
Figure figure();
}
/// Figure 25: collision force on the foreign particle against the voidage.
namespace fig25_collision_force {
Figure figure();
}
/// Figure 26: collision force of the eight systems against Eq. 40.
namespace fig26_force_parity {
Figure figure();
}
/// What one change of the scene, at otherwise equal settings, does to the quantities of the bed and of the sphere that
/// falls through it: the runs of profile causes and those of drag-law that change one thing, over the unchanged scene.
namespace causes {
Figure figure();
}
/// Which drag law and sliding friction bring the bed near the paper's printed voidages, velocities and forces.
namespace drag_law_question {
Figure figure();
}
/// Are the paper's voidages those of its simulated beds? The collision force over the voidage of our own bed, and over
/// the one that Eq. 36 gives for a homogeneous bed at the same superficial velocity, each against Eq. 40.
namespace printed_voidage {
Figure figure();
}
/// Which reading of what the paper leaves open its numbers speak for: ranking, implausibility, packed line and V_2.
namespace most_likely {
Figure figure();
}
/// Steps and stiffness of the paper beside the limits of the stability maps, and what its contact step changes.
namespace paper_steps {
Figure figure();
}
/// From the paper's 66 hours to ours, one change at a time: what each saves and what it costs in each quantity.
namespace from_66_hours {
Figure figure();
}
/// Discretisation error: observed order and grid convergence index over cells and steps.
namespace grid_convergence {
Figure figure();
}
/// For each figure the cheapest choice of tier, stiffness and steps that answers it, beside those of paper and profile.
namespace planned_figures {
Figure figure();
}

/// The paper's bed by measured beds that are alike, beside its printed voidages and each drag law's.
namespace measured_neighbours {
Figure figure();
}

/// All of them in the order of the paper, and behind them those of the numerics; adding one is one line in figures.cpp.
const std::vector<Figure>& figures();

}  // namespace slfb
