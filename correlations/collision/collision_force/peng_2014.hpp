#pragma once

#include <limits>

#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Mean collision force on a foreign sphere over its weight, Peng et al. (2014), Eq. 40:
/// \f$ |F_c|/(m g) = 1.08 + 0.26\,\alpha_L - 1.34\,\alpha_L^2 \f$; 0 at α_L = 1 and 0.948 at the packed 0.425.
///
/// Range: St_p > 65, d_2/d_1 ≤ 2. Confidence: read; the signs, lost in print, are settled by the two values.
struct Peng2014 {
  static constexpr LawInfo info{
      .name = "peng-2014",
      .kind = LawKind::collision_force,
      .title = "Collision force on a foreign sphere, Peng et al. (2014), Eq. 40",
      .equation = "F_c/(m g) = 1.08 + 0.26 e - 1.34 e^2",
      .equation_number = "Eq. 40",
      .source = "peng2014",
      .convention = "mean magnitude of the contact force over the weight of the foreign sphere; no Reynolds number",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.425, 1.0},
      .confidence = Confidence::read,
      .size_ratio = {0.0, 2.0},
      .stokes = {65.0, std::numeric_limits<double>::infinity()}};

  /// \return F_c/(m g) [-]; the settling velocity has no part in it
  double operator()(const ForeignSphereInBed& state, double /*settling_velocity*/) const {
    const double e = state.voidage;
    return 1.08 + 0.26 * e - 1.34 * e * e;
  }
};

}  // namespace slfb::collision
