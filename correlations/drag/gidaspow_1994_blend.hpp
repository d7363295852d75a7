#pragma once

#include <cmath>
#include <numbers>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/ergun_1952.hpp"
#include "correlations/drag/wen_yu_1966.hpp"

namespace slfb::drag {

/// Gidaspow's law with the jump at ε = 0.8 smoothed, as in MFIX (after Huilin & Gidaspow 2003):
/// \f$ F = (1-\varphi) F_{Ergun} + \varphi F_{Wen-Yu} \f$,
/// \f$ \varphi = \tfrac12 + \tfrac1\pi \arctan[150 \cdot 1.75\,(\varepsilon - 0.8)] \f$.
///
/// Range: all voidages. The step is about 0.02 wide in ε. Confidence: read in MFIX.
struct Gidaspow1994Blend {
  static constexpr LawInfo info{.name = "gidaspow-1994-blend",
                                .kind = LawKind::drag,
                                .title = "Ergun and Wen-Yu blended across voidage 0.8",
                                .equation = "F = (1 - p) Ergun + p Wen-Yu, p = 1/2 + atan(262.5 (e - 0.8))/pi",
                                .source = "huilin2003",
                                .convention = "model A; Re = rho e d w / mu (superficial slip)",
                                .reynolds = {0.0, 2e5},
                                .voidage = {0.3, 1.0},
                                .confidence = Confidence::read,
                                .note = "the jump of gidaspow-1994 becomes a steep but continuous fall"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const double wen_yu_share = 0.5 + std::atan(150.0 * 1.75 * (flow.voidage - 0.8)) / std::numbers::pi;
    return (1.0 - wen_yu_share) * Ergun1952{}(flow) + wen_yu_share * WenYu1966{}(flow);
  }
};

}  // namespace slfb::drag
