#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Brown & Lawler (2003), J. Environ. Eng. 129, 222, a fit to 480 points corrected for
/// walls: \f$ C_D = \frac{24}{Re}(1 + 0.150\,Re^{0.681}) + \frac{0.407}{1 + 8710/Re} \f$.
///
/// Range: Re < 2e5. Confidence: read in a test of an open-source fluids library.
struct BrownLawler2003 {
  static constexpr LawInfo info{
      .name = "brown-lawler-2003",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Brown & Lawler (2003)",
      .equation = "C_D = 24/Re (1 + 0.150 Re^0.681) + 0.407/(1 + 8710/Re)",
      .source = "brown2003",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 2e5},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::pow;
    // 0.407 / (1 + 8710/Re) times Re, written without the division by Re.
    const Number newton = 0.407 * reynolds * reynolds / (reynolds + 8710.0);
    return 1.0 + 0.150 * pow(reynolds, 0.681) + newton / 24.0;
  }
};

}  // namespace slfb::drag::single_sphere
