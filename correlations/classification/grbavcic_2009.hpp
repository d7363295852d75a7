#pragma once

#include <algorithm>
#include <limits>

#include "correlations/collision/collision_force/grbavcic_2009.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::classification {

using collision::DisplacedDrag;

/// A velocity known only to lie between two values.
struct VelocityBand {
  double lower;  ///< [m/s]
  double upper;  ///< [m/s]
};

/// Classification velocity from the force balance of Grbavčić et al. (2009), Eqs. 9, 10 and 13–15 of Peng 2014:
/// \f$ \tfrac34 C_D \rho (V_2 + U_L/\varepsilon)^2/d_2 = (\rho_2 - \rho_{eff}) g - \rho_2 g\,F_c/(m g) \f$ with the
/// collision force and the effective density of the same name.
///
/// The transition function f of Ružička (2006) is not at hand, so that the law gives a band over f = 0…1. Confidence:
/// derived.
template <DisplacedDrag reading>
struct Grbavcic2009 {
  static constexpr bool foreign = reading == DisplacedDrag::of_foreign_sphere;
  static constexpr LawInfo info{
      .name = foreign ? "grbavcic-2009" : "grbavcic-2009-bed",
      .kind = LawKind::classification,
      .title = foreign ? "Classification velocity, Grbavcic et al. (2009), Eq. 14 with the foreign sphere"
                       : "Classification velocity, Grbavcic et al. (2009), Eq. 14 with the bed spheres",
      .equation =
          "0.75 C_D rho (V2 + U_L/e)^2/(d2 g) = rho_2 - rho_eff - rho_2 F_c/(m g), rho_eff = (1 - f) rho + f rho_M",
      .equation_number = "Peng 2014, Eqs. 9, 10, 13-15",
      .source = "grbavcic2009",
      .convention = "V2 downwards in the laboratory; slip V2 + U_L/e; C_D of Brown & Lawler (2003) on the slip",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::derived,
      .note = "a band over f = 0 to 1: the transition function of Ruzicka (2006) was not at hand"};

  double transition = 0.5;  ///< f [-], 0…1

  /// \return V_2 [m/s], downwards in the laboratory, at this transition value f
  double operator()(const ForeignSphereInBed& state) const {
    const collision::Grbavcic2009<reading> collision_force{.transition = transition};
    const double net = gravitational_acceleration * (state.foreign.density - collision_force.effective_density(state) -
                                                     state.foreign.density * collision_force(state));
    return fluidisation::slip_velocity(drag::single_sphere::BrownLawler2003{}, state.foreign.diameter, state.liquid,
                                       net) -
           state.interstitial_velocity();
  }

  /// The lowest and highest V_2 over f = 0…1 in steps of 0.05.
  static VelocityBand band(const ForeignSphereInBed& state) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    VelocityBand band{infinity, -infinity};
    constexpr int steps = 20;
    for (int i = 0; i <= steps; ++i) {
      const double velocity = Grbavcic2009{.transition = static_cast<double>(i) / steps}(state);
      band.lower = std::min(band.lower, velocity);
      band.upper = std::max(band.upper, velocity);
    }
    return band;
  }
};

}  // namespace slfb::classification
