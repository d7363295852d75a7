#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag from direct simulations of static arrays, Tang, Peters, Kuipers, Kriebitzsch & van der Hoef (2015), AIChE J.
/// 61, 688, Eq. 21. With s = 1 − ε: \f$ F = \frac{10 s}{\varepsilon^2} + \varepsilon^2 (1 + 1.5\sqrt{s}) + [0.11 s
/// (1+s) - 0.00456\,\varepsilon^{-4} + (0.169\,\varepsilon + 0.0644\,\varepsilon^{-4}) Re^{-0.343}]\,Re \f$.
///
/// Range: Re ≤ 1000, s ≤ 0.6; far beyond it the negative term makes the dilute drag fall. Confidence: read in MFIX.
struct Tang2015 {
  static constexpr LawInfo info{
      .name = "tang-2015",
      .kind = LawKind::drag,
      .title = "Immersed boundary, Tang et al. (2015)",
      .equation =
          "F = 10 s/e^2 + e^2 (1 + 1.5 sqrt(s)) + [0.11 s (1+s) - 0.00456/e^4 + (0.169 e + 0.0644/e^4) Re^-0.343] Re",
      .equation_number = "Eq. 21",
      .source = "tang2015",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.0, 1e3},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::read,
      .note = "do not extrapolate in Re: the term in e^-4 is negative"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    using std::pow;
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const double e4 = e * e * e * e;
    const double creeping = 10.0 * s / (e * e) + e * e * (1.0 + 1.5 * std::sqrt(s));
    return creeping + (0.11 * s * (1.0 + s) - 0.00456 / e4) * flow.reynolds +
           (0.169 * e + 0.0644 / e4) * pow(flow.reynolds, 0.657);
  }
};

}  // namespace slfb::drag
