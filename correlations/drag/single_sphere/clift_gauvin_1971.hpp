#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Clift & Gauvin (1971), Can. J. Chem. Eng. 49, 439:
/// \f$ C_D = \frac{24}{Re}(1 + 0.15\,Re^{0.687}) + \frac{0.42}{1 + 42500\,Re^{-1.16}} \f$.
///
/// Range: Re < 3e5. Confidence: recalled; some libraries carry a refit under the same name.
struct CliftGauvin1971 {
  static constexpr LawInfo info{
      .name = "clift-gauvin-1971",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Clift & Gauvin (1971)",
      .equation = "C_D = 24/Re (1 + 0.15 Re^0.687) + 0.42/(1 + 42500 Re^-1.16)",
      .source = "clift1971",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 3e5},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::recalled};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::pow;
    // 0.42 / (1 + 42500 Re^-1.16) times Re, written without the negative power of Re.
    const Number power = pow(reynolds, 1.16);
    const Number newton = 0.42 * reynolds * power / (power + 42500.0);
    return 1.0 + 0.15 * pow(reynolds, 0.687) + newton / 24.0;
  }
};

}  // namespace slfb::drag::single_sphere
