#pragma once

#include <cmath>
#include <limits>

#include "correlations/fluidisation/expansion_exponent/expansion_conditions.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Exponent of Khan & Richardson (1989) as several codes and teaching sites print it:
/// \f$ \frac{4.8 - n}{n - 2.4} = 0.043\,Ar^{0.57} [1 - 2.4 (d/D)^{0.27}] \f$.
///
/// Range: d/D < 0.039, where the bracket is positive; beyond, n leaves the interval from 2.4 to 4.8. Confidence: read
/// in three of them; khan-richardson-1989 has 1.24 in place of the second 2.4.
struct KhanRichardson1989Codes {
  static constexpr LawInfo info{.name = "khan-richardson-1989-codes",
                                .kind = LawKind::expansion_exponent,
                                .title = "Expansion exponent, Khan & Richardson (1989) as printed by codes",
                                .equation = "(4.8 - n)/(n - 2.4) = 0.043 Ar^0.57 (1 - 2.4 (d/D)^0.27)",
                                .source = "khan1989",
                                .convention = "Ar = d^3 rho (rho_P - rho) g / mu^2; U = U_i e^n",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::read,
                                .note = "beyond d/D = 0.039 the bracket is negative and n is not between 2.4 and 4.8",
                                .variant_of = "khan-richardson-1989",
                                .size_ratio = {0.0, 0.039}};

  /// \return n [-]
  double operator()(const ExpansionConditions& conditions) const {
    const double inertial =
        0.043 * std::pow(conditions.archimedes, 0.57) * (1.0 - 2.4 * std::pow(conditions.diameter_ratio, 0.27));
    return (4.8 + 2.4 * inertial) / (1.0 + inertial);
  }
};

}  // namespace slfb::fluidisation
