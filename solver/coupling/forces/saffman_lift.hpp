#pragma once

#include <cmath>

#include "correlations/materials.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// Lift on a sphere in shear, Saffman (1965), J. Fluid Mech. 22, 385, and 31, 624 (1968):
/// F = 1.615 d² √(ρ μ/|ω|) (w × ω) [N], in simple shear κ of size 6.46 μ r² w √(κ/ν).
///
/// A sphere that lags the liquid along the flow is driven towards the faster liquid, one that leads towards the slower.
/// Key: saffman1965. Range: Re = ρ d w/μ ≪ √Re_ω ≪ 1 with Re_ω = ρ d² |ω|/μ, far from walls.
/// \param slip w = u − v of undisturbed liquid against sphere [m/s]
/// \param vorticity ω = ∇ × u of the undisturbed liquid [1/s]; \param diameter d [m]
inline Vec3 saffman_lift(Vec3 slip, Vec3 vorticity, double diameter, LiquidProperties liquid) {
  const double shear = norm(vorticity);
  if (shear == 0.0) return {};
  return 1.615 * diameter * diameter * std::sqrt(liquid.density * liquid.viscosity / shear) * cross(slip, vorticity);
}

/// Lift at finite Reynolds number over Saffman's, Mei (1992), Int. J. Multiphase Flow 18, 145, after the simulations of
/// Dandy & Dwyer (1990): (1 − 0.3314 √β) e^(−Re/10) + 0.3314 √β for Re ≤ 40 and 0.0524 √(β Re) above, β = Re_ω/(2 Re).
///
/// Key: mei1992. Range: 0.1 < Re < 100, 0.005 < β < 0.4. At Re = 40 it steps down by e⁻⁴ (1 − 0.3314 √β) ≤ 0.018.
/// \param reynolds Re = ρ d |w|/μ [-], > 0
/// \param shear_reynolds Re_ω = ρ d² |ω|/μ [-]
inline double mei_lift_ratio(double reynolds, double shear_reynolds) {
  const double root = std::sqrt(0.5 * shear_reynolds / reynolds);
  if (reynolds > 40.0) return 0.0524 * root * std::sqrt(reynolds);
  return (1.0 - 0.3314 * root) * std::exp(-0.1 * reynolds) + 0.3314 * root;
}

/// Saffman's lift times mei_lift_ratio() [N]; arguments of saffman_lift(); no lift without slip.
inline Vec3 mei_lift(Vec3 slip, Vec3 vorticity, double diameter, LiquidProperties liquid) {
  const double reynolds = reynolds_number(liquid, diameter, norm(slip));
  if (reynolds <= 0.0) return {};
  const double shear_reynolds = reynolds_number(liquid, diameter, diameter * norm(vorticity));
  return mei_lift_ratio(reynolds, shear_reynolds) * saffman_lift(slip, vorticity, diameter, liquid);
}

}  // namespace slfb::coupling
