#pragma once

#include "solver/dem/vec3.hpp"

namespace slfb::coupling {

/// C_m of a sphere alone in potential flow [-] (Batchelor 1967, § 6.4).
inline constexpr double lone_sphere_added_mass = 0.5;

/// C_m of a sphere in a suspension after Zuber (1964), Chem. Eng. Sci. 19, 897: C_m = ½ (1 + 2 s)/(1 − s), s = 1 − α.
///
/// The sphere is moved in the middle of a resting shell of liquid of voidage α (potential flow). Key: zuber1964. Range:
/// dilute suspensions; at α = 0.5 it gives 2, four times the lone sphere, which no measurement in dense beds supports.
/// \param voidage liquid volume fraction α [-], 0 < α ≤ 1
constexpr double zuber_added_mass(double voidage) { return 0.5 * (3.0 - 2.0 * voidage) / voidage; }

/// Force by which a liquid resists that a sphere accelerates relative to it (Auton, Hunt & Prud'homme 1988, J. Fluid
/// Mech. 197, 241): F = C_m ρ V (Du/Dt − dv/dt), D/Dt along the undisturbed liquid's own way.
///
/// The part with dv/dt is an inertia: (m + inertia()) dv/dt = force_of_liquid() + all other forces. Taken as a force
/// from the old dv/dt instead it diverges for spheres lighter than C_m ρ. The undisturbed liquid's pressure gradient,
/// ρ V Du/Dt, is another force. Key: auton1988. Range: inviscid acceleration reaction, which holds at every Reynolds
/// number; flow that changes little over the diameter.
struct AddedMass {
  double coefficient;     ///< C_m [-]
  double liquid_density;  ///< ρ [kg/m³]
  double volume;          ///< V of the sphere [m³]

  /// C_m ρ V [kg].
  [[nodiscard]] constexpr double inertia() const { return coefficient * liquid_density * volume; }
  /// C_m ρ V Du/Dt [N]. \param acceleration Du/Dt [m/s²]
  [[nodiscard]] dem::Vec3 force_of_liquid(dem::Vec3 acceleration) const { return inertia() * acceleration; }
};

}  // namespace slfb::coupling
