#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "correlations/collision/restitution/wet_impact.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Restitution of a rough sphere in a liquid after Barnocky & Davis (1988), Phys. Fluids 31, 1324: lubrication slows
/// the sphere until the gap is as small as the roughness k, \f$ e/e_{dry} = 1 + \ln(2 k/d)/St \f$, \f$ St = \rho_P U
/// d/(9\mu) \f$, and 0 where that is negative.
///
/// Range: k much smaller than d. Confidence: read in a script of the Yade project.
struct BarnockyDavis1988 {
  static constexpr LawInfo info{
      .name = "barnocky-davis-1988",
      .kind = LawKind::restitution,
      .title = "Restitution in a liquid from lubrication down to the roughness, Barnocky & Davis (1988)",
      .equation = "e_wet/e_dry = max(0, 1 + ln(2 k/d)/St), St = rho_P U d/(9 mu)",
      .source = "barnocky1988",
      .convention = "St of the sphere; impact speed U; roughness k",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read};

  /// \return wet over dry restitution [-]
  double operator()(const WetImpact& impact) const {
    const double stokes =
        impact.sphere.density * impact.speed * impact.sphere.diameter / (9.0 * impact.liquid.viscosity);
    return std::max(0.0, 1.0 + std::log(2.0 * impact.roughness / impact.sphere.diameter) / stokes);
  }
};

}  // namespace slfb::collision
