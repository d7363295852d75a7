#pragma once

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag in a packed bed between walls after Eisfeld & Schnitzlein (2001), Chem. Eng. Sci. 56, 4321, Ergun's equation
/// with the wall terms of Reichelt: \f$ F = \frac{154 A_w^2 (1-\varepsilon) + (A_w/B_w) Re}{18\,\varepsilon^2} \f$,
/// \f$ A_w = 1 + \frac{2 d/D}{3 (1-\varepsilon)} \f$, \f$ B_w = [1.15 (d/D)^2 + 0.87]^2 \f$.
///
/// Range: packed beds of spheres, 0.01 < Re < 17635. Confidence: recalled; the three constants were read.
struct EisfeldSchnitzlein2001 {
  static constexpr LawInfo info{
      .name = "eisfeld-schnitzlein-2001",
      .kind = LawKind::drag,
      .title = "Packed bed between walls, Eisfeld & Schnitzlein (2001)",
      .equation =
          "F = (154 A^2 (1 - e) + (A/B) Re)/(18 e^2), A = 1 + 2 r/(3 (1 - e)), B = (1.15 r^2 + 0.87)^2, r = d/D = 0.1",
      .source = "eisfeld2001",
      .convention = "model A; Re = rho e d w / mu (superficial slip); r is that of 5 mm spheres in the 50 mm column",
      .reynolds = {0.01, 17635.0},
      .voidage = {0.33, 0.88},
      .confidence = Confidence::recalled,
      .note = "infinite without spheres; without walls (r = 0) it is 154 and 1.321 in place of Ergun's 150 and 1.75"};

  double diameter_ratio = 0.1;  ///< sphere over column diameter d/D [-]; 5 mm in 50 mm

  /// \param flow voidage ε < 1 [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const double surface = s + 2.0 / 3.0 * diameter_ratio;  // A_w s
    const double root = 1.15 * diameter_ratio * diameter_ratio + 0.87;
    return (154.0 * surface * surface + surface / (root * root) * flow.reynolds) / (18.0 * e * e * s);
  }
};

}  // namespace slfb::drag
