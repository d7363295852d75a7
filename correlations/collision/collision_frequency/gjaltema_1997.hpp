#pragma once

#include <limits>
#include <numbers>

#include "correlations/collision/collision_frequency/collision_state.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Collision frequency of a foreign sphere that drifts through resting bed spheres, as in Gjaltema et al. (1997); Eq. 5
/// of Peng 2014 over n_2: \f$ f = N_{12}/n_2 = \pi n_1 d_{12}^2 U_r \f$.
///
/// Range: drift well above the velocity fluctuations. Confidence: derived: it is the volume swept per time.
struct Gjaltema1997 {
  static constexpr LawInfo info{
      .name = "gjaltema-1997",
      .kind = LawKind::collision_frequency,
      .title = "Collision frequency of a drifting sphere, Peng Eq. 5",
      .equation = "f = pi n1 d12^2 U_r, d12 = (d1 + d2)/2",
      .equation_number = "Peng 2014, Eq. 5",
      .source = "gjaltema1997",
      .convention = "n1 is the number density of the bed; U_r is the drift of the foreign sphere through it",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.425, 1.0},
      .confidence = Confidence::derived};

  /// \return collisions of one foreign sphere with bed spheres per time [1/s]
  double operator()(const CollisionState& state) const {
    const double distance = state.contact_distance();
    return std::numbers::pi * state.bed_number_density() * distance * distance * state.relative_velocity;
  }
};

}  // namespace slfb::collision
