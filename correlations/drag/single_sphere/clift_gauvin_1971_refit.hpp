#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// The form of Clift & Gauvin (1971) with fitted constants that other sources print under their name:
/// \f$ C_D = \frac{24}{Re}(1 + 0.152\,Re^{0.677}) + \frac{0.417}{1 + 5070\,Re^{-0.94}} \f$.
///
/// Range: Re < 3e5. Confidence: read in the Python library fluids, whose example at Re = 200 it reproduces.
struct CliftGauvin1971Refit {
  static constexpr LawInfo info{
      .name = "clift-gauvin-1971-refit",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Clift & Gauvin (1971) with fitted constants",
      .equation = "C_D = 24/Re (1 + 0.152 Re^0.677) + 0.417/(1 + 5070 Re^-0.94)",
      .source = "clift1971",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 3e5},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read,
      .variant_of = "clift-gauvin-1971"};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::pow;
    // 0.417 / (1 + 5070 Re^-0.94) times Re, written without the negative power of Re.
    const Number power = pow(reynolds, 0.94);
    const Number newton = 0.417 * reynolds * power / (power + 5070.0);
    return 1.0 + 0.152 * pow(reynolds, 0.677) + newton / 24.0;
  }
};

}  // namespace slfb::drag::single_sphere
