#pragma once

#include "correlations/law.hpp"

namespace slfb::drag {

/// State of a homogeneous suspension as every drag law sees it.
struct SuspensionFlow {
  double voidage;   ///< liquid volume fraction ε [-], 0 < ε ≤ 1
  double reynolds;  ///< Re = ρ ε d w / μ on the superficial slip velocity ε w (Peng 2014, Eq. 25) [-]
};

/// Momentum-exchange coefficient β [kg/(m³ s)] from the dimensionless drag.
///
/// Each law returns F = f_d / (3 π μ d ε w), f_d the drag on one sphere without the pressure-gradient force
/// (Gidaspow's model A). Then β = 18 μ ε (1 − ε) F / d², and f_d = V β w / (1 − ε) is Eq. 22 of Peng 2014.
constexpr double exchange_coefficient(double dimensionless_drag, double voidage, double diameter, double viscosity) {
  return 18.0 * viscosity * voidage * (1.0 - voidage) * dimensionless_drag / (diameter * diameter);
}

/// β / (1 − ε) [kg/(m³ s)]: drag per particle volume and slip velocity; finite where ε → 1.
constexpr double exchange_per_solid_volume(double dimensionless_drag, double voidage, double diameter,
                                           double viscosity) {
  return 18.0 * viscosity * voidage * dimensionless_drag / (diameter * diameter);
}

}  // namespace slfb::drag
