#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution at contact after Sinclair & Jackson (1989), AIChE J. 35, 1473; Eq. 4 of Peng 2014:
/// \f$ g_0 = [1 - (\alpha_S/\alpha_{Sm})^{1/3}]^{-1} \f$.
///
/// Range: α_S < α_Sm. It does not tend to 1 + 2.5 α_S when dilute. Confidence: read in OpenFOAM.
struct SinclairJackson1989 {
  static constexpr LawInfo info{
      .name = "sinclair-jackson-1989",
      .kind = LawKind::radial_distribution,
      .title = "Contact value of the pair distribution, Sinclair & Jackson (1989), Peng Eq. 4",
      .equation = "g0 = 1/(1 - (a/am)^(1/3)), am = 0.575",
      .equation_number = "Peng 2014, Eq. 4",
      .source = "sinclair1989",
      .convention = "a = 1 - e is the solids fraction",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.425, 1.0},
      .confidence = Confidence::read};

  double packed_solids = 0.575;  ///< α_Sm at which spheres jam [-]; the value Peng 2014 measured

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]; infinite from the packing on
  double operator()(double solids) const {
    if (solids >= packed_solids) return std::numeric_limits<double>::infinity();
    return 1.0 / (1.0 - std::cbrt(solids / packed_solids));
  }
};

}  // namespace slfb::collision
