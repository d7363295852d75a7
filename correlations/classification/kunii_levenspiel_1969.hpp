#pragma once

#include <cmath>
#include <limits>

#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::classification {

/// Classification velocity after Kunii & Levenspiel (1969), "Fluidization Engineering": a sphere in Newton's regime
/// falls through a liquid as dense as the bed, \f$ V_2 = \sqrt{\frac{4 g d_2 (\rho_2 - \rho_M)}{3 \cdot 0.44\,\rho_M}}
/// - U_L \f$.
///
/// Confidence: reconstructed; that U_L is subtracted is inferred from the frame of Fig. 11 of Peng 2014.
struct KuniiLevenspiel1969 {
  static constexpr LawInfo info{
      .name = "kunii-levenspiel-1969",
      .kind = LawKind::classification,
      .title = "Classification velocity, Kunii & Levenspiel (1969)",
      .equation = "V2 = sqrt(4 g d2 (rho_2 - rho_M)/(3 0.44 rho_M)) - U_L",
      .source = "kunii1969",
      .convention = "V2 downwards in the laboratory; slip V2 + U_L in a liquid of density rho_M; C_D = 0.44",
      .reynolds = {1e3, std::numeric_limits<double>::infinity()},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::reconstructed};

  /// \return V_2 [m/s], downwards in the laboratory
  double operator()(const ForeignSphereInBed& state) const {
    const double density = state.mixture_density();
    const double drive = 4.0 * gravitational_acceleration * state.foreign.diameter * state.excess_density();
    return std::sqrt(drive / (3.0 * 0.44 * density)) - state.superficial_velocity;
  }
};

}  // namespace slfb::classification
