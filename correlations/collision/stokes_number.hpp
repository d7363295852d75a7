#pragma once

#include <cmath>

#include "correlations/materials.hpp"

namespace slfb::collision {

/// Particle Stokes number St_p = ρ_P √(q_p²) d / (9 μ) [-], Eq. 8 of Peng 2014: inertia over viscous drag at impact.
/// \param kinetic_energy q_p² = (3/2)⟨u_p'²⟩ of one velocity component [m²/s²]
inline double stokes_number(Sphere sphere, LiquidProperties liquid, double kinetic_energy) {
  return sphere.density * std::sqrt(kinetic_energy) * sphere.diameter / (9.0 * liquid.viscosity);
}

}  // namespace slfb::collision
