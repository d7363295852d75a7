#pragma once

#include <cmath>
#include <limits>

#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Mean collision force on a foreign sphere over its weight after van der Wielen et al. (1996); Eq. 12 of Peng 2014:
/// \f$ F_c/(m g) = \lambda\,\alpha_S V_2 \f$, \f$ \lambda = 10.5\,(d_1/d_2)^{0.95} \f$ s/m.
///
/// Confidence: derived. The sign of the exponent and α_S (the text prints α_L, which would push the force above the
/// weight) follow from the limits of an infinitely fine and of an infinitely dilute bed.
struct VanDerWielen1996 {
  static constexpr LawInfo info{
      .name = "van-der-wielen-1996-force",
      .kind = LawKind::collision_force,
      .title = "Collision force on a foreign sphere, van der Wielen et al. (1996), Peng Eq. 12",
      .equation = "F_c/(m g) = 10.5 (d1/d2)^0.95 a V2",
      .equation_number = "Peng 2014, Eq. 12",
      .source = "vanderwielen1996",
      .convention = "a = 1 - e; V2 in m/s, downwards in the laboratory",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.0, 1.0},
      .confidence = Confidence::derived,
      .note = "the exponent sign and the solids fraction are settled by limits"};

  /// \param settling_velocity V_2 [m/s]
  /// \return F_c/(m g) [-]
  double operator()(const ForeignSphereInBed& state, double settling_velocity) const {
    return coefficient(state) * state.solids() * settling_velocity;
  }

  /// λ [s/m].
  static double coefficient(const ForeignSphereInBed& state) {
    return 10.5 * std::pow(state.bed.diameter / state.foreign.diameter, 0.95);
  }
};

}  // namespace slfb::collision
