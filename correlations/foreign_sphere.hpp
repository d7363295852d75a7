#pragma once

#include <stdexcept>

#include "correlations/materials.hpp"

namespace slfb {

/// One foreign sphere in a homogeneous fluidised bed; index 1 of the literature is the bed, index 2 the foreign sphere.
struct ForeignSphereInBed {
  Sphere bed;
  Sphere foreign;
  LiquidProperties liquid;
  double voidage;               ///< ε, α_L of the bed [-]
  double superficial_velocity;  ///< U_L, upwards [m/s]

  [[nodiscard]] constexpr double solids() const { return 1.0 - voidage; }
  [[nodiscard]] constexpr double mixture_density() const { return suspension_density(voidage, bed, liquid); }

  /// Upward velocity of the liquid between the particles U_L/ε [m/s]. Bed particles rest on average, so that the slip
  /// of a foreign sphere that falls at V_2 in the laboratory is V_2 + U_L/ε.
  [[nodiscard]] constexpr double interstitial_velocity() const { return superficial_velocity / voidage; }

  /// ρ_2 − ρ_M [kg/m³], what drives the foreign sphere down through the suspension.
  /// \throws std::domain_error for a sphere that floats on the suspension
  [[nodiscard]] constexpr double excess_density() const {
    if (!(foreign.density > mixture_density())) throw std::domain_error("the foreign sphere floats on the suspension");
    return foreign.density - mixture_density();
  }
};

}  // namespace slfb
