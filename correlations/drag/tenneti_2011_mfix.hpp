#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// The law of Tenneti, Garg & Subramaniam (2011) as MFIX 21.3 codes it, with s = 1 − ε: \f$ F = \frac{1 + 0.15
/// Re^{0.687}}{\varepsilon^3} + \frac{5.81 s}{\varepsilon^3} + \frac{0.48 s^{1/3}}{\varepsilon^4} + s^3 Re\,(0.95 +
/// \frac{0.61 s^{1/3}}{\varepsilon^2}) \f$.
///
/// Range: that of tenneti-2011. Confidence: read in MFIX. s^(1/3) stands where tenneti-2011 has the last s³, and the
/// total force is taken for the drag of model A.
struct Tenneti2011Mfix {
  static constexpr LawInfo info{
      .name = "tenneti-2011-mfix",
      .kind = LawKind::drag,
      .title = "Tenneti, Garg & Subramaniam (2011) as in MFIX",
      .equation = "F = (1 + 0.15 Re^0.687)/e^3 + 5.81 s/e^3 + 0.48 s^(1/3)/e^4 + s^3 Re (0.95 + 0.61 s^(1/3)/e^2)",
      .source = "tenneti2011",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.01, 300.0},
      .voidage = {0.5, 0.9},
      .confidence = Confidence::read,
      .note = "the last power of s is 1/3 and the factor e of model A is left out",
      .variant_of = "tenneti-2011"};

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
    const Number inertia = s * s * s * flow.reynolds * (0.95 + 0.61 * std::cbrt(s) / (e * e));
    return single_sphere + crowding + inertia;
  }
};

}  // namespace slfb::drag
