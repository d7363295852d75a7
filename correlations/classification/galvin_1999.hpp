#pragma once

#include <cmath>
#include <limits>

#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/expansion_exponent/richardson_zaki_1954.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::classification {

/// Classification velocity after Galvin, Pratten & Nguyen Tran Lam (1999), Chem. Eng. Sci. 54, 1045: the slip follows
/// the buoyancy in the suspension, \f$ V_2 = u_{t2} [\frac{\rho_2 - \rho_M}{\rho_2 - \rho}]^{n_2 - 1} - U_L/\varepsilon
/// \f$.
///
/// Not among the paper's models; a contrast. Confidence: recalled, the abstract was read.
struct Galvin1999 {
  static constexpr LawInfo info{.name = "galvin-1999",
                                .kind = LawKind::classification,
                                .title = "Classification velocity, Galvin, Pratten & Nguyen Tran Lam (1999)",
                                .equation = "V2 = u_t2 ((rho_2 - rho_M)/(rho_2 - rho))^(n2 - 1) - U_L/e",
                                .source = "galvin1999",
                                .convention =
                                    "V2 downwards in the laboratory; u_t2 after Brown & Lawler (2003); n2 after "
                                    "Richardson & Zaki (1954), no walls",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::recalled,
                                .note = "far too fast for a heavy sphere: a contrast, not a candidate"};

  /// \return V_2 [m/s], downwards in the laboratory
  double operator()(const ForeignSphereInBed& state) const {
    const double terminal =
        fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, state.foreign, state.liquid);
    const double exponent = fluidisation::RichardsonZaki1954{}(
        {.terminal_reynolds = reynolds_number(state.liquid, state.foreign.diameter, terminal),
         .archimedes = archimedes_number(state.foreign, state.liquid),
         .diameter_ratio = 0.0});
    const double buoyancy = state.excess_density() / (state.foreign.density - state.liquid.density);
    return terminal * std::pow(buoyancy, exponent - 1.0) - state.interstitial_velocity();
  }
};

}  // namespace slfb::classification
