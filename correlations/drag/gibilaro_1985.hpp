#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag in packed and fluidised beds after Gibilaro, Di Felice, Waldram & Foscolo (1985), Chem. Eng. Sci. 40, 1817:
/// \f$ F = \tfrac{1}{18}(17.3 + 0.336\,Re)\,\varepsilon^{-3.8} \f$.
///
/// Range: packed and expanded beds. For a single sphere it gives C_D = 23.07/Re + 0.448, which is wrong at intermediate
/// Re. Confidence: read in OpenFOAM and in a review table.
struct Gibilaro1985 {
  static constexpr LawInfo info{
      .name = "gibilaro-1985",
      .kind = LawKind::drag,
      .title = "Packed and fluidised beds, Gibilaro et al. (1985)",
      .equation = "F = (17.3 + 0.336 Re) e^-3.8 / 18",
      .source = "gibilaro1985",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.0, 1e4},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::read,
      .note = "single-sphere limit C_D = 23.07/Re + 0.448 underestimates drag at 1 < Re < 500"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    return (17.3 + 0.336 * flow.reynolds) / 18.0 * std::pow(flow.voidage, -3.8);
  }
};

}  // namespace slfb::drag
