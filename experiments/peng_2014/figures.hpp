#pragma once

#include "experiments/figures/figure.hpp"

/// The figures of the paper and of the questions that it leaves open, each a folder with its code and README.
namespace slfb {

/// Table 1: conditions of the paper, those used here, and what does not add up.
Figure table1();
/// Table 2: straight lines fitted to the fall through the window.
Figure table2();
/// Figure 1: the meshing template, and how far each void-fraction scheme is from exact overlap at what cost.
Figure fig01();
/// Figure 2: the domain and our mesh.
Figure fig02();
/// Figure 3: the rig of the settling experiments, drawn from the paper's description.
Figure fig03();
/// Figure 4: the same column with particle image velocimetry.
Figure fig04();
/// Figure 5: pressure drop of the bed against the superficial velocity.
Figure fig05();
/// Figure 6: the bed at the end of the fall around minimum fluidisation.
Figure fig06();
/// Figure 7: height of the steel sphere against time around minimum fluidisation.
Figure fig07();
/// Figure 8: history of the steel sphere at U_L = 0.10 m/s.
Figure fig08();
/// Figure 9: height of the steel sphere against time, and the straight lines through it.
Figure fig09();
/// Figure 10 and Table 2: classification velocity against the superficial velocity.
Figure fig10();
/// Figure 11: predicted against measured classification velocity.
Figure fig11();
/// Figure 12: fluctuation of the liquid's velocity against the voidage.
Figure fig12();
/// Figure 13: void fraction in the plane y = 0.
Figure fig13();
/// Figure 14: vorticity, speed and direction of the liquid in the plane y = 0.
Figure fig14();
/// Figure 15: the steel sphere on its way through 3 mm glass at three voidages.
Figure fig15();
/// Figure 16: mean and largest number of contacts of the steel sphere in 3 mm glass.
Figure fig16();
/// Figure 17: contacts and velocity of the foreign sphere over a tenth of a second.
Figure fig17();
/// Figure 18: fluctuating kinetic energy of the fluidised particles.
Figure fig18();
/// Figure 19: dimensionless collision frequency against the kinetic theory.
Figure fig19();
/// Figure 20: collision frequency of the eight systems.
Figure fig20();
/// Figure 21: collision force in time at six voidages.
Figure fig21();
/// Figure 22: drag and pressure-gradient force on the steel sphere.
Figure fig22();
/// Figure 23: collision force over drag.
Figure fig23();
/// Figure 24: collision force against the voidage, and the correlation fitted to it.
Figure fig24();
/// Figure 25: collision force on the foreign particle against the voidage.
Figure fig25();
/// Figure 26: collision force of the eight systems against Eq. 40.
Figure fig26();
/// What one change of the scene, at otherwise equal settings, does to the quantities of the bed and of the sphere that
/// falls through it: the runs of profile causes and those of drag-law that change one thing, over the unchanged scene.
Figure causes();
/// Which drag law and sliding friction bring the bed near the paper's printed voidages, velocities and forces.
Figure drag_law_question();
/// Are the paper's voidages those of its simulated beds? The collision force over the voidage of our own bed, and over
/// the one that Eq. 36 gives for a homogeneous bed at the same superficial velocity, each against Eq. 40.
Figure printed_voidage();
/// Steps and stiffness of the paper beside the limits of the stability maps, and what its contact step changes.
Figure paper_steps();
/// From the paper's 66 hours to ours, one change at a time: what each saves and what it costs in each quantity.
Figure from_66_hours();
/// For each figure the cheapest choice of tier, stiffness and steps that answers it, beside those of paper and profile.
Figure planned_figures();

/// All of them in the order of the paper, and behind them those of the numerics; adding one is one line in figures.cpp.
const std::vector<Figure>& figures();

}  // namespace slfb
