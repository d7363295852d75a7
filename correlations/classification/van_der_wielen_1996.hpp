#pragma once

#include <limits>

#include "correlations/collision/collision_force/van_der_wielen_1996.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"
#include "correlations/root.hpp"

namespace slfb::classification {

/// Classification velocity from the force balance of van der Wielen et al. (1996), Eqs. 9–12 of Peng 2014:
/// \f$ 1 - \frac{\rho_M}{\rho_2} - \frac{3 C_D \rho (V_2 + U_L/\varepsilon)^2}{4 d_2 g \rho_2} = \lambda\,\alpha_S V_2
/// \f$ with the collision force of the same name.
///
/// Confidence: derived; the paper does not say which C_D stands in Eq. 10.
struct VanDerWielen1996 {
  static constexpr LawInfo info{
      .name = "van-der-wielen-1996",
      .kind = LawKind::classification,
      .title = "Classification velocity, van der Wielen et al. (1996), Peng Eqs. 9-12",
      .equation = "1 - rho_M/rho_2 - 0.75 C_D rho (V2 + U_L/e)^2/(d2 g rho_2) = 10.5 (d1/d2)^0.95 a V2",
      .equation_number = "Peng 2014, Eqs. 9-12",
      .source = "vanderwielen1996",
      .convention = "V2 downwards in the laboratory; slip V2 + U_L/e; C_D of Brown & Lawler (2003) on the slip",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::derived};

  /// \return V_2 [m/s], downwards in the laboratory
  double operator()(const ForeignSphereInBed& state) const {
    const drag::single_sphere::BrownLawler2003 law;
    const collision::VanDerWielen1996 collision_force;
    const double upflow = state.interstitial_velocity();
    const double diameter = state.foreign.diameter;
    const double weight_per_volume = state.foreign.density * gravitational_acceleration;
    auto imbalance = [&](double velocity) {
      const double slip = velocity + upflow;
      const double stokes_drag = 18.0 * state.liquid.viscosity * slip / (diameter * diameter);
      const double drag = stokes_drag * law(reynolds_number(state.liquid, diameter, slip)) / weight_per_volume;
      return 1.0 - state.mixture_density() / state.foreign.density - drag - collision_force(state, velocity);
    };
    // At zero slip the sphere is pulled down; 100 m/s is beyond any settling sphere in a liquid.
    return bracketed_root(imbalance, -upflow, 100.0, "classification velocity [m/s]");
  }
};

}  // namespace slfb::classification
