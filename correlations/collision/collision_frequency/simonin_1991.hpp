#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "correlations/collision/collision_frequency/collision_state.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Collision frequency of like spheres in kinetic theory after Simonin (1991); Eq. 6 of Peng 2014:
/// \f$ f^* = f d/\sqrt{q_p^2} = 24 \sqrt{\tfrac{2}{3\pi}}\,\alpha_S g_0 = 11.056\,\alpha_S g_0 \f$.
///
/// Range: rapid granular flow without drift between the species. Confidence: derived (the radical is lost in the
/// source).
struct Simonin1991 {
  static constexpr LawInfo info{
      .name = "simonin-1991",
      .kind = LawKind::collision_frequency,
      .title = "Collision frequency of like spheres, kinetic theory, Peng Eq. 6",
      .equation = "f d/sqrt(q2) = 24 sqrt(2/(3 pi)) a g0",
      .equation_number = "Peng 2014, Eq. 6",
      .source = "simonin1991",
      .convention = "a = 1 - e; q2 = 3/2 <u_p^2> of one velocity component; d is the bed sphere",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.425, 1.0},
      .confidence = Confidence::derived};

  /// \return collisions of one foreign sphere with bed spheres per time [1/s]
  double operator()(const CollisionState& state) const {
    const double dimensionless = 24.0 * std::sqrt(2.0 / (3.0 * std::numbers::pi)) * state.solids * state.contact_value;
    return dimensionless * std::sqrt(state.kinetic_energy) / state.bed_diameter;
  }
};

}  // namespace slfb::collision
