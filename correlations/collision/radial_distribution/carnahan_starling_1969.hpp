#pragma once

#include <limits>

#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution of hard spheres at contact after Carnahan & Starling (1969), J. Chem. Phys. 51, 635:
/// \f$ g_0 = \frac{1 - \alpha_S/2}{(1 - \alpha_S)^3} \f$.
///
/// Range: the hard-sphere fluid, α_S below about 0.5; stays finite at packing. Confidence: read in MFIX and OpenFOAM.
struct CarnahanStarling1969 {
  static constexpr LawInfo info{.name = "carnahan-starling-1969",
                                .kind = LawKind::radial_distribution,
                                .title = "Contact value of the pair distribution, Carnahan & Starling (1969)",
                                .equation = "g0 = (1 - a/2)/(1 - a)^3",
                                .source = "carnahan1969",
                                .convention = "a = 1 - e is the solids fraction",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.45, 1.0},
                                .confidence = Confidence::read};

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]
  double operator()(double solids) const {
    const double e = 1.0 - solids;
    return (1.0 - 0.5 * solids) / (e * e * e);
  }
};

}  // namespace slfb::collision
