#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution at contact after Ding & Gidaspow (1990), AIChE J. 36, 523:
/// \f$ g_0 = \tfrac35 [1 - (\alpha_S/\alpha_{Sm})^{1/3}]^{-1} \f$.
///
/// Range: dense suspensions; it tends to 0.6 when dilute. Confidence: recalled.
struct DingGidaspow1990 {
  static constexpr LawInfo info{.name = "ding-gidaspow-1990",
                                .kind = LawKind::radial_distribution,
                                .title = "Contact value of the pair distribution, Ding & Gidaspow (1990)",
                                .equation = "g0 = 0.6/(1 - (a/am)^(1/3)), am = 0.575",
                                .source = "ding1990",
                                .convention = "a = 1 - e is the solids fraction",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.425, 1.0},
                                .confidence = Confidence::recalled};

  double packed_solids = 0.575;  ///< α_Sm at which spheres jam [-]; the value Peng 2014 measured

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]; infinite from the packing on
  double operator()(double solids) const {
    if (solids >= packed_solids) return std::numeric_limits<double>::infinity();
    return 0.6 / (1.0 - std::cbrt(solids / packed_solids));
  }
};

}  // namespace slfb::collision
