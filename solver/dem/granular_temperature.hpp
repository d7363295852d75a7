#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "solver/dem/particles.hpp"

namespace slfb::dem {

/// Fluctuating kinetic energy per mass q_p² = (3/2) u'² of spheres (Peng 2014, Eq. 39) [m²/s²]; u'² is the variance of
/// one velocity component, mean of the three: the granular temperature Θ. So q_p² = ½ Σ_a ⟨(u_a − ū_a)²⟩. All spheres
/// count alike whatever their mass; `excluded`, a foreign sphere, does not count.

/// About the mean velocity of all n spheres, over n − 1: without bias for independent velocities. Circulation of the
/// bed is part of it. 0 for fewer than two spheres.
double fluctuating_energy(const Particles& particles, std::optional<std::size_t> excluded = {});

/// About the mean velocity in each box of the grid with edges `box` [m] through the origin; an edge of 0 does not
/// divide its direction.
///
/// The squares of all boxes are added up and divided by Σ_b (n_b − 1): the unbiased variance of each box weighted by
/// n_b − 1, so that a box with a single sphere says nothing. Without bias at any n_b if Θ is uniform; else the mean of
/// Θ leans a little to full boxes. Of a mean flow whose gradient is G, Σ_ab G_ab² h_b²/24 remains (spheres uniform in
/// boxes of edges h; linear shear at rate γ: γ²h²/24, rotation at ω: ω²h²/12). 0 if no box has two spheres.
double local_fluctuating_energy(const Particles& particles, const std::array<double, 3>& box,
                                std::optional<std::size_t> excluded = {});

}  // namespace slfb::dem
