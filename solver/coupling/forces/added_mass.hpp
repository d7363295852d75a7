#pragma once

#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// Force by which a liquid resists that a sphere accelerates relative to it (Auton, Hunt & Prud'homme 1988, J. Fluid
/// Mech. 197, 241): F = C_m ρ V (Du/Dt − dv/dt), D/Dt along the undisturbed liquid's own way.
///
/// The part with dv/dt is an inertia: (m + inertia()) dv/dt = force_of_liquid() + all other forces. Taken as a force
/// from the old dv/dt instead it diverges for spheres lighter than C_m ρ. The undisturbed liquid's pressure gradient,
/// ρ V Du/Dt, is another force. Key: auton1988. Range: inviscid acceleration reaction, which holds at every Reynolds
/// number; flow that changes little over the diameter.
struct AddedMass {
  double coefficient;     ///< C_m [-]; ½ for a sphere alone in potential flow (Batchelor 1967, § 6.4)
  double liquid_density;  ///< ρ [kg/m³]
  double volume;          ///< V of the sphere [m³]

  /// C_m ρ V [kg].
  [[nodiscard]] constexpr double inertia() const { return coefficient * liquid_density * volume; }
  /// C_m ρ V Du/Dt [N]. \param acceleration Du/Dt [m/s²]
  [[nodiscard]] Vec3 force_of_liquid(Vec3 acceleration) const { return inertia() * acceleration; }
};

}  // namespace slfb::coupling
