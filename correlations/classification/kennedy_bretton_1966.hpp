#pragma once

#include <cmath>
#include <limits>

#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/expansion_exponent/richardson_zaki_1954.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::classification {

/// Classification velocity after Kennedy & Bretton (1966), AIChE J. 12, 24: the slip of the foreign sphere is that in a
/// bed of its own kind at the same voidage, \f$ V_2 = u_{t2}\,\varepsilon^{n_2 - 1} - U_L/\varepsilon \f$.
///
/// For a sphere like those of the bed V_2 = 0. Confidence: reconstructed from the idea; the exact form was not at hand.
struct KennedyBretton1966 {
  static constexpr LawInfo info{.name = "kennedy-bretton-1966",
                                .kind = LawKind::classification,
                                .title = "Classification velocity, Kennedy & Bretton (1966)",
                                .equation = "V2 = u_t2 e^(n2 - 1) - U_L/e",
                                .source = "kennedy1966",
                                .convention =
                                    "V2 downwards in the laboratory; u_t2 after Brown & Lawler (2003); n2 after "
                                    "Richardson & Zaki (1954), no walls",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::reconstructed};

  /// \return V_2 [m/s], downwards in the laboratory
  double operator()(const ForeignSphereInBed& state) const {
    const double terminal =
        fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, state.foreign, state.liquid);
    const double exponent = fluidisation::RichardsonZaki1954{}(
        {.terminal_reynolds = reynolds_number(state.liquid, state.foreign.diameter, terminal),
         .archimedes = archimedes_number(state.foreign, state.liquid),
         .diameter_ratio = 0.0});
    return terminal * std::pow(state.voidage, exponent - 1.0) - state.interstitial_velocity();
  }
};

}  // namespace slfb::classification
