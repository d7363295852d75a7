#pragma once

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Ergun's law with the constants that the markers of his own Fig. 7 give when they are fitted again:
/// \f$ F = \frac{151.9\,(1-\varepsilon)}{18\,\varepsilon^2} + \frac{1.697\,Re}{18\,\varepsilon^2} \f$.
///
/// Range: packed beds, 1 < Re/(1 − ε) < 2500. Confidence: derived, a fit to 244 digitised markers, which scatter by
/// 7.1 % around the printed 150 and 1.75.
struct Ergun1952Refit {
  static constexpr LawInfo info{.name = "ergun-1952-refit",
                                .kind = LawKind::drag,
                                .title = "Packed bed, the markers of Ergun's Fig. 7 fitted again",
                                .equation = "F = 151.9 (1 - e)/(18 e^2) + 1.697 Re/(18 e^2)",
                                .source = "ergun1952",
                                .convention = "model A; Re = rho e d w / mu (superficial slip)",
                                .reynolds = {0.4, 1500.0},
                                .voidage = {0.3, 0.5},
                                .confidence = Confidence::derived,
                                .note = "shows how well the markers determine the two constants",
                                .variant_of = "ergun-1952"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const double e = flow.voidage;
    return (151.9 * (1.0 - e) + 1.697 * flow.reynolds) / (18.0 * e * e);
  }
};

}  // namespace slfb::drag
