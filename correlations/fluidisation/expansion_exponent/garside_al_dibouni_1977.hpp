#pragma once

#include <cmath>
#include <limits>

#include "correlations/fluidisation/expansion_exponent/expansion_conditions.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Exponent of the bed expansion after Garside & Al-Dibouni (1977), Ind. Eng. Chem. Process Des. Dev. 16, 206:
/// \f$ \frac{5.09 - n}{n - 2.73} = 0.104\,Re_t^{0.877} \f$.
///
/// Range: all Re_t, no wall effect. Confidence: recalled.
struct GarsideAlDibouni1977 {
  static constexpr LawInfo info{.name = "garside-al-dibouni-1977",
                                .kind = LawKind::expansion_exponent,
                                .title = "Expansion exponent, Garside & Al-Dibouni (1977)",
                                .equation = "(5.09 - n)/(n - 2.73) = 0.104 Re_t^0.877",
                                .source = "garside1977",
                                .convention = "Re_t = rho u_t d / mu on the terminal velocity; U = U_i e^n",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::recalled};

  /// \return n [-]
  double operator()(const ExpansionConditions& conditions) const {
    const double inertial = 0.104 * std::pow(conditions.terminal_reynolds, 0.877);
    return (5.09 + 2.73 * inertial) / (1.0 + inertial);
  }
};

}  // namespace slfb::fluidisation
