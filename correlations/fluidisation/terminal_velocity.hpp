#pragma once

#include <stdexcept>

#include "correlations/materials.hpp"
#include "correlations/root.hpp"

namespace slfb::fluidisation {

/// Velocity [m/s] relative to unbounded liquid at which the drag on a sphere balances a force, found with GSL.
/// \param law a single-sphere drag law, which returns C_D Re / 24
/// \param force_per_volume the force that drag has to balance, over the sphere's volume [N/m³], ≥ 0
template <class Law>
double slip_velocity(const Law& law, double diameter, LiquidProperties liquid, double force_per_volume) {
  if (!(force_per_volume >= 0.0)) {
    throw std::domain_error("the force on the sphere, weight less buoyancy and contacts, points upwards");
  }
  // Drag 3 π μ d w F over the volume π d³/6 is 18 μ² Re F / (ρ d³), so that the balance reads Re F = target.
  const double target =
      force_per_volume * liquid.density * diameter * diameter * diameter / (18.0 * liquid.viscosity * liquid.viscosity);
  double upper = 1.0;
  while (upper * law(upper) < target && upper < 1e12) upper *= 2.0;
  const double reynolds =
      bracketed_root([&](double re) { return re * law(re) - target; }, 0.0, upper, "Reynolds number of the sphere [-]");
  return reynolds * liquid.viscosity / (liquid.density * diameter);
}

/// Terminal settling velocity [m/s] of a sphere in unbounded liquid: ¾ C_D ρ u²/d = (ρ_P − ρ) g.
/// \param law a single-sphere drag law, which returns C_D Re / 24
/// \throws std::domain_error for a sphere lighter than the liquid
template <class Law>
double terminal_velocity(const Law& law, Sphere sphere, LiquidProperties liquid) {
  return slip_velocity(law, sphere.diameter, liquid, (sphere.density - liquid.density) * gravitational_acceleration);
}

}  // namespace slfb::fluidisation
