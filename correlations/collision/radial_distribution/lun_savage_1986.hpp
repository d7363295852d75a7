#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution at contact after Lun & Savage (1986), Acta Mech. 63, 15; Eq. 7 of Peng 2014:
/// \f$ g_0 = (1 - \alpha_S/\alpha_{Sm})^{-2.5 \alpha_{Sm}} \f$.
///
/// Range: α_S < α_Sm. Limit 1 + 2.5 α_S when dilute. Confidence: read in OpenFOAM, and settled by the frame of Fig. 19.
struct LunSavage1986 {
  static constexpr LawInfo info{.name = "lun-savage-1986",
                                .kind = LawKind::radial_distribution,
                                .title = "Contact value of the pair distribution, Lun & Savage (1986), Peng Eq. 7",
                                .equation = "g0 = (1 - a/am)^(-2.5 am), am = 0.575",
                                .equation_number = "Peng 2014, Eq. 7",
                                .source = "lun1986",
                                .convention = "a = 1 - e is the solids fraction",
                                .reynolds = {0.0, std::numeric_limits<double>::infinity()},
                                .voidage = {0.425, 1.0},
                                .confidence = Confidence::read};

  double packed_solids = 0.575;  ///< α_Sm at which spheres jam [-]; the value Peng 2014 measured

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]; infinite from the packing on
  double operator()(double solids) const {
    if (solids >= packed_solids) return std::numeric_limits<double>::infinity();
    return std::pow(1.0 - solids / packed_solids, -2.5 * packed_solids);
  }
};

}  // namespace slfb::collision
