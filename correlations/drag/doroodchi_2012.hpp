#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// The drag law behind Eq. 36 of Peng 2014 (there after Doroodchi et al. 2012), in the normalisation of this suite:
/// \f$ F = \tfrac{1}{18}(18 + 0.33\,Re)\,\varepsilon^{-3.8} \f$.
///
/// It is the law of Gibilaro et al. (1985) with 17.3 → 18 (Stokes) and 0.336 → 0.33 (¾ · 0.44). The voidages printed
/// with Fig. 13 of Peng 2014 follow it to 0.005. Confidence: derived from Eq. 36, whose terms were settled by their
/// limits.
struct Doroodchi2012 {
  static constexpr LawInfo info{.name = "doroodchi-2012",
                                .kind = LawKind::drag,
                                .title = "Revised Ergun equation, Doroodchi et al. (2012), Peng Eq. 36",
                                .equation = "F = (18 + 0.33 Re) e^-3.8 / 18",
                                .equation_number = "Peng 2014, Eq. 36",
                                .source = "doroodchi2012",
                                .convention = "model A; Re = rho e d w / mu (superficial slip)",
                                .reynolds = {0.0, 1e4},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::derived,
                                .note =
                                    "written for minimum fluidisation in its source; the printed voidages of Peng 2014 "
                                    "follow it for the whole bed"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    return (18.0 + 0.33 * flow.reynolds) / 18.0 * std::pow(flow.voidage, -3.8);
  }
};

}  // namespace slfb::drag
