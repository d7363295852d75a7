#pragma once

#include <cmath>
#include <limits>

#include "correlations/fluidisation/expansion_exponent/expansion_conditions.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Exponent of the bed expansion after Rowe (1987), Chem. Eng. Sci. 42, 2795:
/// \f$ n = 2.35\,\frac{2 + 0.175\,Re_t^{0.75}}{1 + 0.175\,Re_t^{0.75}} \f$, between 4.7 (viscous) and 2.35 (inertial).
///
/// Range: all Re_t, no wall effect. Confidence: recalled.
struct Rowe1987 {
  static constexpr LawInfo info{.name = "rowe-1987",
                                .kind = LawKind::expansion_exponent,
                                .title = "Expansion exponent, Rowe (1987)",
                                .equation = "n = 2.35 (2 + 0.175 Re_t^0.75)/(1 + 0.175 Re_t^0.75)",
                                .source = "rowe1987",
                                .convention = "Re_t = rho u_t d / mu on the terminal velocity; U = U_i e^n",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::recalled};

  /// \return n [-]
  double operator()(const ExpansionConditions& conditions) const {
    const double inertial = 0.175 * std::pow(conditions.terminal_reynolds, 0.75);
    return 2.35 * (2.0 + inertial) / (1.0 + inertial);
  }
};

}  // namespace slfb::fluidisation
