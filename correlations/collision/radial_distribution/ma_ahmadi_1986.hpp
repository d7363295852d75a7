#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution at contact after Ma & Ahmadi (1986), J. Chem. Phys. 84, 3449:
/// \f$ g_0 = \frac{1 + 2.5 \alpha_S + 4.5094 \alpha_S^2 + 4.515439 \alpha_S^3}{[1 - (\alpha_S/0.64356)^3]^{0.678021}}
/// \f$.
///
/// Range: α_S < 0.64356. Confidence: read in MFIX.
struct MaAhmadi1986 {
  static constexpr LawInfo info{.name = "ma-ahmadi-1986",
                                .kind = LawKind::radial_distribution,
                                .title = "Contact value of the pair distribution, Ma & Ahmadi (1986)",
                                .equation = "g0 = (1 + 2.5 a + 4.5094 a^2 + 4.515439 a^3)/(1 - (a/0.64356)^3)^0.678021",
                                .source = "ma1986",
                                .convention = "a = 1 - e is the solids fraction",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.36, 1.0},
                                .confidence = Confidence::read};

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]; infinite from the packing on
  double operator()(double solids) const {
    if (solids >= 0.64356) return std::numeric_limits<double>::infinity();

    const double crowding = solids / 0.64356;
    return (1.0 + solids * (2.5 + solids * (4.5094 + solids * 4.515439))) /
           std::pow(1.0 - crowding * crowding * crowding, 0.678021);
  }
};

}  // namespace slfb::collision
