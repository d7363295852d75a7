#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "correlations/collision/collision_frequency/collision_state.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Collision frequency of a foreign sphere in kinetic theory where it and the bed fluctuate differently:
/// \f$ f = N_{12}/n_2 = 2 n_1 d_{12}^2 g_0 \sqrt{2 \pi (\Theta_1 + \Theta_2)} \f$, Θ the variance of one velocity
/// component.
///
/// Range: Maxwellian velocities, no drift. For Θ_2 = Θ_1 it is Eq. 2 of Peng 2014. Confidence: derived.
struct Gidaspow1994Unequal {
  static constexpr LawInfo info{
      .name = "gidaspow-1994-unequal-fluctuations",
      .kind = LawKind::collision_frequency,
      .title = "Collision frequency of unlike spheres with unlike fluctuations, kinetic theory",
      .equation = "f = 2 n1 d12^2 g0 sqrt(2 pi (T1 + T2)), d12 = (d1 + d2)/2, T = 2/3 q2",
      .source = "gidaspow1994",
      .convention = "n1 is the number density of the bed; q2 = 3/2 <u_p^2> of one velocity component of each",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.425, 1.0},
      .confidence = Confidence::derived};

  /// \return collisions of one foreign sphere with bed spheres per time [1/s]
  double operator()(const CollisionState& state) const {
    const double distance = state.contact_distance();
    const double variances = 2.0 / 3.0 * (state.kinetic_energy + state.foreign_kinetic_energy);
    return 2.0 * state.bed_number_density() * distance * distance * state.contact_value *
           std::sqrt(2.0 * std::numbers::pi * variances);
  }
};

}  // namespace slfb::collision
