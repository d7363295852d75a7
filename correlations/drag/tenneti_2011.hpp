#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag from direct simulations of fixed assemblies, Tenneti, Garg & Subramaniam (2011), Int. J. Multiphase Flow 37,
/// 1072. With s = 1 − ε: \f$ F = \varepsilon\,[\frac{1 + 0.15 Re^{0.687}}{\varepsilon^3} + \frac{5.81 s}{\varepsilon^3}
/// + \frac{0.48 s^{1/3}}{\varepsilon^4} + s^3 Re\,(0.95 + \frac{0.61 s^3}{\varepsilon^2})] \f$.
///
/// Range: 0.1 ≤ s ≤ 0.5, 0.01 ≤ Re ≤ 300. The source gives the total force; the factor ε makes it the drag of model A.
/// Confidence: read in OpenFOAM. MFIX writes s^(1/3) where this has the last s³ and leaves the factor ε out.
struct Tenneti2011 {
  static constexpr LawInfo info{
      .name = "tenneti-2011",
      .kind = LawKind::drag,
      .title = "Immersed boundary, Tenneti, Garg & Subramaniam (2011)",
      .equation = "F = e [(1 + 0.15 Re^0.687)/e^3 + 5.81 s/e^3 + 0.48 s^(1/3)/e^4 + s^3 Re (0.95 + 0.61 s^3/e^2)]",
      .source = "tenneti2011",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.01, 300.0},
      .voidage = {0.5, 0.9},
      .confidence = Confidence::read,
      .note = "codes disagree on the last power of s (3 here, 1/3 in MFIX)"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    using std::pow;
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const double e3 = e * e * e;
    const Number single_sphere = (1.0 + 0.15 * pow(flow.reynolds, 0.687)) / e3;
    const double crowding = 5.81 * s / e3 + 0.48 * std::cbrt(s) / (e3 * e);
    const Number inertia = s * s * s * flow.reynolds * (0.95 + 0.61 * s * s * s / (e * e));
    return e * (single_sphere + crowding + inertia);
  }
};

}  // namespace slfb::drag
