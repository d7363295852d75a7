#pragma once

#include <cmath>
#include <limits>

#include "correlations/collision/restitution/wet_impact.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Restitution of a sphere in a liquid after Legendre, Daniel & Guiraud (2005), Phys. Fluids 17, 097105:
/// \f$ e/e_{dry} = \exp(-35/St^*) \f$, \f$ St^* = (\rho_P + \rho/2) U d/(9\mu) \f$.
///
/// Range: solid spheres and drops, St* up to about 5000. Confidence: recalled; two digitised bounces of Gondret et al.
/// (2002) lie above it at low St*.
struct Legendre2005 {
  static constexpr LawInfo info{.name = "legendre-2005",
                                .kind = LawKind::restitution,
                                .title = "Restitution in a liquid, Legendre, Daniel & Guiraud (2005)",
                                .equation = "e_wet/e_dry = exp(-35/St), St = (rho_P + rho/2) U d/(9 mu)",
                                .source = "legendre2005",
                                .convention = "St with the added mass of the sphere; impact speed U",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {1.0, 1.0},
                                .confidence = Confidence::recalled};

  /// \return wet over dry restitution [-]
  double operator()(const WetImpact& impact) const {
    const double inertia = impact.sphere.density + 0.5 * impact.liquid.density;
    return std::exp(-35.0 * 9.0 * impact.liquid.viscosity / (inertia * impact.speed * impact.sphere.diameter));
  }
};

}  // namespace slfb::collision
