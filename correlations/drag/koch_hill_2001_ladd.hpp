#pragma once

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/koch_hill_2001.hpp"

namespace slfb::drag {

/// The short form of Koch & Hill (2001) with the 17.14 of Hill, Koch & Ladd (2001) in F_0, where CFDEM has 16.14:
/// \f$ F = \varepsilon\,(F_0 + \tfrac12 F_3 Re) \f$.
///
/// Range: moderate Re, where the drag is linear in Re. Confidence: read; MFIX has the constant in its form of
/// hill-koch-ladd-2001.
struct KochHill2001Ladd {
  static constexpr LawInfo info{
      .name = "koch-hill-2001-ladd",
      .kind = LawKind::drag,
      .title = "Koch & Hill (2001) with the constant of Hill, Koch & Ladd (2001)",
      .equation = "F = e (F0 + F3 Re/2), F3 = 0.0673 + 0.212 s + 0.0232/e^5, F0 with 17.14 s in place of 16.14 s",
      .source = "hill2001",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.0, 200.0},
      .voidage = {0.36, 1.0},
      .confidence = Confidence::read,
      .variant_of = "koch-hill-2001"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    return KochHill2001::drag(flow, 17.14);
  }
};

}  // namespace slfb::drag
