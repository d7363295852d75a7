#pragma once

#include <cmath>
#include <limits>

#include "correlations/fluidisation/expansion_exponent/expansion_conditions.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Exponent of the bed expansion after Khan & Richardson (1989), Chem. Eng. Commun. 78, 111:
/// \f$ \frac{4.8 - n}{n - 2.4} = 0.043\,Ar^{0.57} [1 - 1.24 (d/D)^{0.27}] \f$.
///
/// Range: all Archimedes numbers. Confidence: recalled. Several codes print 2.4 in place of 1.24, which turns the
/// bracket negative beyond d/D = 0.039.
struct KhanRichardson1989 {
  static constexpr LawInfo info{.name = "khan-richardson-1989",
                                .kind = LawKind::expansion_exponent,
                                .title = "Expansion exponent, Khan & Richardson (1989)",
                                .equation = "(4.8 - n)/(n - 2.4) = 0.043 Ar^0.57 (1 - 1.24 (d/D)^0.27)",
                                .source = "khan1989",
                                .convention = "Ar = d^3 rho (rho_P - rho) g / mu^2; U = U_i e^n",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::recalled,
                                .note = "1.24 is recalled; codes with 2.4 in its place fail beyond d/D = 0.039"};

  /// \return n [-]
  double operator()(const ExpansionConditions& conditions) const {
    const double inertial =
        0.043 * std::pow(conditions.archimedes, 0.57) * (1.0 - 1.24 * std::pow(conditions.diameter_ratio, 0.27));
    return (4.8 + 2.4 * inertial) / (1.0 + inertial);
  }
};

}  // namespace slfb::fluidisation
