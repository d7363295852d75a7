#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "correlations/collision/collision_frequency/collision_state.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Collision frequency of a foreign sphere in kinetic theory after Gidaspow (1994); Eq. 2 of Peng 2014 over n_2:
/// \f$ f = N_{12}/n_2 = 4 n_1 d_{12}^2 g_0 \sqrt{\pi \Theta} \f$, Θ the granular temperature of both species.
///
/// Range: equal granular temperatures, no drift. For d_2 = d_1 it is Eq. 6. Confidence: derived.
struct Gidaspow1994 {
  static constexpr LawInfo info{
      .name = "gidaspow-1994-collision-frequency",
      .kind = LawKind::collision_frequency,
      .title = "Collision frequency of unlike spheres, kinetic theory, Peng Eq. 2",
      .equation = "f = 4 n1 d12^2 g0 sqrt(pi T), d12 = (d1 + d2)/2, T = 2/3 q2",
      .equation_number = "Peng 2014, Eq. 2",
      .source = "gidaspow1994",
      .convention =
          "n1 is the number density of the bed; q2 = 3/2 <u_p^2> of one velocity component, the same for both",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.425, 1.0},
      .confidence = Confidence::derived};

  /// \return collisions of one foreign sphere with bed spheres per time [1/s]
  double operator()(const CollisionState& state) const {
    const double distance = state.contact_distance();
    const double temperature = 2.0 / 3.0 * state.kinetic_energy;
    return 4.0 * state.bed_number_density() * distance * distance * state.contact_value *
           std::sqrt(std::numbers::pi * temperature);
  }
};

}  // namespace slfb::collision
