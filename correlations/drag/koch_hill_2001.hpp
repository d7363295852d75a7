#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag from lattice-Boltzmann simulations in the short form of Koch & Hill (2001), Annu. Rev. Fluid Mech. 33, 619:
/// \f$ F = \varepsilon\,(F_0 + \tfrac12 F_3 Re) \f$ with s = 1 − ε,
/// \f$ F_0 = \frac{1 + 3\sqrt{s/2} + \frac{135}{64} s \ln s + 16.14 s}{1 + 0.681 s - 8.48 s^2 + 8.16 s^3} \f$ for s <
/// 0.4 and \f$ 10 s/\varepsilon^3 \f$ above, \f$ F_3 = 0.0673 + 0.212 s + 0.0232\,\varepsilon^{-5} \f$.
///
/// Range: moderate Re, where the drag is linear in Re. Confidence: read in CFDEM. Hill, Koch & Ladd (2001) have 17.14
/// in place of 16.14.
struct KochHill2001 {
  static constexpr LawInfo info{
      .name = "koch-hill-2001",
      .kind = LawKind::drag,
      .title = "Lattice Boltzmann, Koch & Hill (2001), form used by CFD-DEM codes",
      .equation = "F = e (F0 + F3 Re/2), F3 = 0.0673 + 0.212 s + 0.0232/e^5, F0 the Stokes drag of the array",
      .source = "kochhill2001",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.0, 200.0},
      .voidage = {0.36, 1.0},
      .confidence = Confidence::read,
      .note = "constant 16.14 as in CFDEM; hill-koch-ladd-2001 has 17.14"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    return drag(flow, 16.14);
  }

  /// F with one or the other constant of the linear term of F_0, on which the sources disagree.
  template <class Number>
  static Number drag(SuspensionFlowOf<Number> flow, double linear) {
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const double f3 = 0.0673 + 0.212 * s + 0.0232 / std::pow(e, 5);
    return e * (creeping(s, linear) + 0.5 * f3 * flow.reynolds);
  }

 private:
  static double creeping(double s, double linear) {
    if (s >= 0.4) return 10.0 * s / std::pow(1.0 - s, 3);
    if (s <= 0.0) return 1.0;
    return (1.0 + 3.0 * std::sqrt(0.5 * s) + 135.0 / 64.0 * s * std::log(s) + linear * s) /
           (1.0 + 0.681 * s - 8.48 * s * s + 8.16 * s * s * s);
  }
};

}  // namespace slfb::drag
