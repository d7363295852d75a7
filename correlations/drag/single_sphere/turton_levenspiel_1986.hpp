#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Turton & Levenspiel (1986), Powder Technol. 47, 83:
/// \f$ C_D = \frac{24}{Re}(1 + 0.173\,Re^{0.657}) + \frac{0.413}{1 + 16300\,Re^{-1.09}} \f$.
///
/// Range: Re < 2e5. Confidence: read in MFIX.
struct TurtonLevenspiel1986 {
  static constexpr LawInfo info{
      .name = "turton-levenspiel-1986",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Turton & Levenspiel (1986)",
      .equation = "C_D = 24/Re (1 + 0.173 Re^0.657) + 0.413/(1 + 16300 Re^-1.09)",
      .source = "turton1986",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 2e5},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::pow;
    // 0.413 / (1 + 16300 Re^-1.09) times Re, written without the negative power of Re.
    const Number power = pow(reynolds, 1.09);
    const Number newton = 0.413 * reynolds * power / (power + 16300.0);
    return 1.0 + 0.173 * pow(reynolds, 0.657) + newton / 24.0;
  }
};

}  // namespace slfb::drag::single_sphere
