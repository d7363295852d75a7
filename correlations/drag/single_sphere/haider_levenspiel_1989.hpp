#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Haider & Levenspiel (1989), Powder Technol. 58, 63, at sphericity 1:
/// \f$ C_D = \frac{24}{Re}(1 + 0.1806\,Re^{0.6459}) + \frac{0.4251}{1 + 6880.95/Re} \f$.
///
/// Range: Re ≤ 2e5. Confidence: read in the Python library fluids, whose example at Re = 200 it reproduces.
struct HaiderLevenspiel1989 {
  static constexpr LawInfo info{
      .name = "haider-levenspiel-1989",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Haider & Levenspiel (1989)",
      .equation = "C_D = 24/Re (1 + 0.1806 Re^0.6459) + 0.4251/(1 + 6880.95/Re)",
      .source = "haider1989",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 2e5},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::pow;
    // 0.4251 / (1 + 6880.95/Re) times Re, written without the division by Re.
    const Number newton = 0.4251 * reynolds * reynolds / (reynolds + 6880.95);
    return 1.0 + 0.1806 * pow(reynolds, 0.6459) + newton / 24.0;
  }
};

}  // namespace slfb::drag::single_sphere
