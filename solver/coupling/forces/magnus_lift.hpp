#pragma once

#include <cmath>
#include <numbers>

#include "correlations/materials.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// Rotation of the liquid relative to the sphere, ½ ω − Ω [rad/s].
/// \param vorticity ω = ∇ × u of the undisturbed liquid [1/s]
/// \param angular_velocity Ω of the sphere [rad/s]
inline Vec3 relative_rotation(Vec3 vorticity, Vec3 angular_velocity) { return 0.5 * vorticity - angular_velocity; }

/// Lift on a rotating sphere, Rubinow & Keller (1961), J. Fluid Mech. 11, 447: F = π/8 ρ d³ (½ ω − Ω) × w [N].
///
/// Key: rubinow1961. Range: Re = ρ d w/μ ≪ 1; it grows with the rotation without bound.
/// \param rotation relative_rotation() [rad/s]
/// \param slip w = u − v [m/s]; \param diameter d [m]
inline Vec3 rubinow_keller_lift(Vec3 rotation, Vec3 slip, double diameter, LiquidProperties liquid) {
  return std::numbers::pi / 8.0 * liquid.density * diameter * diameter * diameter * cross(rotation, slip);
}

/// Lift on a rotating sphere at finite Reynolds number, Oesterlé & Bui Dinh (1998), Exp. Fluids 25, 16:
/// F = π/8 ρ d² C |w| (Γ × w)/|Γ|, C = 0.45 + (Re_r/Re − 0.45) exp(−0.05684 Re_r^0.4 Re^0.3), Γ = ½ ω − Ω,
/// Re_r = ρ d² |Γ|/μ.
///
/// Key: oesterle1998. Range: 10 < Re < 140, 1 < d|Γ|/(2 w) < 6; for Re → 0 it becomes Rubinow and Keller's.
/// Arguments of rubinow_keller_lift(); no lift without slip or rotation. \return force on the sphere [N]
inline Vec3 oesterle_bui_dinh_lift(Vec3 rotation, Vec3 slip, double diameter, LiquidProperties liquid) {
  const double reynolds = reynolds_number(liquid, diameter, norm(slip));
  const double rotation_reynolds = reynolds_number(liquid, diameter, diameter * norm(rotation));
  if (reynolds <= 0.0 || rotation_reynolds <= 0.0) return {};
  const double ratio = rotation_reynolds / reynolds;
  const double coefficient =
      0.45 + (ratio - 0.45) * std::exp(-0.05684 * std::pow(rotation_reynolds, 0.4) * std::pow(reynolds, 0.3));
  return coefficient / ratio * rubinow_keller_lift(rotation, slip, diameter, liquid);
}

/// Torque of the liquid on a rotating sphere: T = π μ d³ (½ ω − Ω) = 8 π μ r³ (½ ω − Ω) in creeping flow (Kirchhoff),
/// and above Re_r = 32 T = ½ ρ r⁵ C |Γ| Γ, C = 12.9/√Re_r + 128.4/Re_r, Dennis, Singh & Ingham (1980), J. Fluid Mech.
/// 101, 257.
///
/// Key: dennis1980. Range: Re_r = ρ d² |Γ|/μ up to 4000, no slip of the centre. The pieces meet within 0.2 %.
/// \param rotation Γ = relative_rotation() [rad/s]; \param diameter d [m]
/// \return torque on the sphere [N m]
inline Vec3 viscous_torque(Vec3 rotation, double diameter, LiquidProperties liquid) {
  const double reynolds = reynolds_number(liquid, diameter, diameter * norm(rotation));
  const double creeping = std::numbers::pi * liquid.viscosity * diameter * diameter * diameter;
  // C over that of creeping flow, 64 π/Re_r.
  const double ratio = reynolds > 32.0 ? (12.9 * std::sqrt(reynolds) + 128.4) / (64.0 * std::numbers::pi) : 1.0;
  return ratio * creeping * rotation;
}

}  // namespace slfb::coupling
