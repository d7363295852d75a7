#pragma once

#include <cmath>

namespace slfb::fluidisation {

/// What the laws for the exponent n of U = U_i ε^n ask for; each law uses some of it.
struct ExpansionConditions {
  double terminal_reynolds;  ///< Re_t = ρ u_t d / μ on the terminal velocity of one sphere [-]
  double archimedes;         ///< Ar = d³ ρ (ρ_P − ρ) g / μ² [-]
  double diameter_ratio;     ///< sphere over column diameter d/D [-]; 0 without walls
};

/// Superficial velocity U = U_i ε^n [m/s] of Richardson and Zaki.
/// \param intercept U_i, the velocity extrapolated to ε = 1 [m/s]
inline double expansion_velocity(double intercept, double exponent, double voidage) {
  return intercept * std::pow(voidage, exponent);
}

/// Voidage ε = (U/U_i)^(1/n) [-] of Richardson and Zaki.
inline double expansion_voidage(double intercept, double exponent, double velocity) {
  return std::pow(velocity / intercept, 1.0 / exponent);
}

}  // namespace slfb::fluidisation
