#pragma once

#include <numbers>

#include "correlations/dual.hpp"
#include "correlations/law.hpp"
#include "correlations/law_parameters.hpp"

namespace slfb::drag {

/// State of a homogeneous suspension as every drag law sees it. The Reynolds number may be of any kind of number, so
/// that a law gives its derivative with respect to the slip when it is handed a Dual.
template <class Number>
struct SuspensionFlowOf {
  double voidage;   ///< liquid volume fraction ε [-], 0 < ε ≤ 1
  Number reynolds;  ///< Re = ρ ε d w / μ on the superficial slip velocity ε w (Peng 2014, Eq. 25) [-]
};
using SuspensionFlow = SuspensionFlowOf<double>;

/// Momentum-exchange coefficient β [kg/(m³ s)] from the dimensionless drag.
///
/// Each law returns F = f_d / (3 π μ d ε w), f_d the drag on one sphere without the pressure-gradient force
/// (Gidaspow's model A). Then β = 18 μ ε (1 − ε) F / d², and f_d = V β w / (1 − ε) is Eq. 22 of Peng 2014.
constexpr double exchange_coefficient(double dimensionless_drag, double voidage, double diameter, double viscosity) {
  return 18.0 * viscosity * voidage * (1.0 - voidage) * dimensionless_drag / (diameter * diameter);
}

/// Derivative of the drag with respect to the slip, ∂f_d/∂w over 3 π μ d ε, [-]: F + Re ∂F/∂Re, for the implicit
/// treatment of the drag. Where a law has a kink it is the derivative of the branch that holds there.
template <class Law>
double slip_derivative(const Law& law, SuspensionFlow flow) {
  // F has an infinite slope where Re = 0 in many laws, but Re ∂F/∂Re vanishes there.
  if (flow.reynolds == 0.0) return law(flow);
  const Dual drag = law(SuspensionFlowOf<Dual>{flow.voidage, {flow.reynolds, 1.0}});
  return drag.value + flow.reynolds * drag.slope;
}

/// Stokes drag 3 π μ d of one sphere over its velocity [N s/m].
constexpr double stokes_drag_coefficient(double diameter, double viscosity) {
  return 3.0 * std::numbers::pi * viscosity * diameter;
}

/// β / (1 − ε) [kg/(m³ s)]: drag per particle volume and slip velocity; finite where ε → 1.
constexpr double exchange_per_solid_volume(double dimensionless_drag, double voidage, double diameter,
                                           double viscosity) {
  return 18.0 * viscosity * voidage * dimensionless_drag / (diameter * diameter);
}

}  // namespace slfb::drag
