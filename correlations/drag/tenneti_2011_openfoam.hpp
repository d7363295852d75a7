#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/single_sphere/schiller_naumann_1935.hpp"

namespace slfb::drag {

/// The law of Tenneti, Garg & Subramaniam (2011) as OpenFOAM 9 codes it, with s = 1 − ε: \f$ F = \frac{C_D Re}{24
/// \varepsilon} + \varepsilon\,[\frac{5.81 s}{\varepsilon^3} + \frac{0.48 s^{1/3}}{\varepsilon^4} + s^3 Re\,(0.95 +
/// \frac{0.61 s^3}{\varepsilon^2})] \f$, C_D of Schiller & Naumann (1935).
///
/// Range: that of tenneti-2011. Confidence: read in OpenFOAM, which adds the drag of the isolated sphere with one
/// factor 1/ε less than the source.
struct Tenneti2011Openfoam {
  static constexpr LawInfo info{
      .name = "tenneti-2011-openfoam",
      .kind = LawKind::drag,
      .title = "Tenneti, Garg & Subramaniam (2011) as in OpenFOAM",
      .equation = "F = (C_D Re/24)/e + e [5.81 s/e^3 + 0.48 s^(1/3)/e^4 + s^3 Re (0.95 + 0.61 s^3/e^2)]",
      .source = "tenneti2011",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.01, 300.0},
      .voidage = {0.5, 0.9},
      .confidence = Confidence::read,
      .note = "the isolated sphere enters with 1/e where the source has 1/e^2",
      .variant_of = "tenneti-2011"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const double e3 = e * e * e;
    const Number isolated = single_sphere::SchillerNaumann1935{}(flow.reynolds) / e;
    const double crowding = 5.81 * s / e3 + 0.48 * std::cbrt(s) / (e3 * e);
    const Number inertia = s * s * s * flow.reynolds * (0.95 + 0.61 * s * s * s / (e * e));
    return isolated + e * (crowding + inertia);
  }
};

}  // namespace slfb::drag
