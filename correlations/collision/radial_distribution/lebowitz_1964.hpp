#pragma once

#include <limits>

#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution at contact of one foreign sphere in a bed of spheres after Lebowitz (1964), Phys. Rev. 133, A895,
/// in the limit of a single foreign sphere: \f$ g_{12} = \frac{1}{\varepsilon} + \frac{3 \alpha_S r}{\varepsilon^2 (1 +
/// r)} \f$, r = d_2/d_1.
///
/// Range: the hard-sphere fluid. Confidence: read in MFIX for any mixture; the limit is taken here.
struct Lebowitz1964 {
  static constexpr LawInfo info{.name = "lebowitz-1964",
                                .kind = LawKind::radial_distribution,
                                .title = "Contact value for a foreign sphere of another size, Lebowitz (1964)",
                                .equation = "g0 = 1/e + 3 a r/(e^2 (1 + r)), r = d2/d1",
                                .source = "lebowitz1964",
                                .convention = "a = 1 - e is the solids fraction",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.45, 1.0},
                                .confidence = Confidence::read};

  double diameter_ratio = 1.2;  ///< d_2/d_1 of the foreign and the bed sphere [-]; 6 mm in 5 mm

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]
  double operator()(double solids) const {
    const double e = 1.0 - solids;
    return 1.0 / e + 3.0 * solids * diameter_ratio / (e * e * (1.0 + diameter_ratio));
  }
};

}  // namespace slfb::collision
