#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include "correlations/drag/single_sphere/dalla_valle_1948.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::classification {

/// Classification velocity after Di Felice, Foscolo, Gibilaro & Rapagnà (1991), Chem. Eng. Sci. 46, 1873: the bed acts
/// as a Newtonian fluid of density ρ_M and of the viscosity in which a bed particle would be at its terminal velocity
/// U_L, \f$ \tfrac34 C_D(Re_M) \rho_M U_L^2/d_1 = (\rho_1 - \rho_M) g \f$, \f$ Re_M = \rho_M U_L d_1/\mu_M \f$. The
/// foreign sphere falls through that fluid, V_2 = W − U_L.
///
/// For a sphere like those of the bed V_2 = 0. Good to about 40 % solids. Confidence: reconstructed from an abstract.
struct DiFelice1991 {
  static constexpr LawInfo info{
      .name = "di-felice-1991",
      .kind = LawKind::classification,
      .title = "Classification velocity, pseudo-fluid of Di Felice et al. (1991)",
      .equation = "V2 = W - U_L, W the terminal velocity in a fluid of density rho_M and viscosity mu_M",
      .source = "difelice1991",
      .convention = "V2 downwards in the laboratory; slip V2 + U_L in the pseudo-fluid; C_D of Dalla Valle (1948)",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::reconstructed};

  /// \return V_2 [m/s], downwards in the laboratory
  double operator()(const ForeignSphereInBed& state) const {
    const LiquidProperties fluid{state.mixture_density(), pseudo_viscosity(state)};
    return fluidisation::terminal_velocity(drag::single_sphere::DallaValle1948{}, state.foreign, fluid) -
           state.superficial_velocity;
  }

  /// Viscosity μ_M of the pseudo-fluid [Pa s].
  /// \throws std::domain_error where the bed particles fall more slowly than U_L in a fluid without viscosity
  static double pseudo_viscosity(const ForeignSphereInBed& state) {
    const double density = state.mixture_density();
    const double velocity = state.superficial_velocity;
    const double drag_coefficient = 4.0 / 3.0 * (state.bed.density - density) * gravitational_acceleration *
                                    state.bed.diameter / (density * velocity * velocity);
    // Dalla Valle's law solved for the Reynolds number.
    const double viscous = std::sqrt(drag_coefficient) - 0.63;
    if (viscous <= 0.0) throw std::domain_error("no pseudo-fluid viscosity: the superficial velocity is too high");
    const double reynolds = (4.8 / viscous) * (4.8 / viscous);
    return density * velocity * state.bed.diameter / reynolds;
  }
};

}  // namespace slfb::classification
