#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag from lattice-Boltzmann simulations, Hill, Koch & Ladd (2001), J. Fluid Mech. 448, 213 and 243, in the form that
/// Benyahia, Syamlal & O'Brien (2006), Powder Technol. 162, 166 extended to all voidages and Reynolds numbers.
///
/// With s = 1 − ε and R = Re/2, the total force is \f$ 1 + \tfrac38 R \f$ or \f$ F_0 + F_1 R^2 \f$ at small R and
/// \f$ F_2 + F_3 R \f$ at large R; the drag of model A is ε times that. The coefficients are below.
///
/// Range: Re up to about 200, then extrapolated linearly. Confidence: read in MFIX.
struct HillKochLadd2001 {
  static constexpr LawInfo info{
      .name = "hill-koch-ladd-2001",
      .kind = LawKind::drag,
      .title = "Lattice Boltzmann, Hill, Koch & Ladd (2001), all-range form",
      .equation = "F = e (F0 + F1 R^2) at small R, e (F2 + F3 R) at large R, R = Re/2, F0..F3 functions of s = 1 - e",
      .source = "hill2001",
      .convention = "model A; Re = rho e d w / mu (superficial slip); the source uses R = Re/2",
      .reynolds = {0.0, 200.0},
      .voidage = {0.36, 1.0},
      .confidence = Confidence::read,
      .note = "all-range form of Benyahia et al. (2006); small steps where the pieces meet"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const Number r = 0.5 * flow.reynolds;
    const double f0 = creeping(s, 17.14, 0.681, -8.48, 8.16);
    const double f2 = creeping(s, 17.89, 0.681, -11.03, 15.41);
    const double f3 = s < 0.0953 ? 0.9351 * s + 0.03667 : 0.0673 + 0.212 * s + 0.0232 / std::pow(e, 5);
    if (s <= 0.01) {
      const bool oseen = r <= (f2 - 1.0) / (3.0 / 8.0 - f3);
      return e * (oseen ? 1.0 + 3.0 / 8.0 * r : f2 + f3 * r);
    }
    const double f1 = s <= 0.1 ? std::sqrt(2.0 / s) / 40.0 : 0.11 + 5.1e-4 * std::exp(11.6 * s);
    const double onset = (f3 + std::sqrt(f3 * f3 - 4.0 * f1 * (f0 - f2))) / (2.0 * f1);
    return e * (r <= onset ? f0 + f1 * r * r : f2 + f3 * r);
  }

 private:
  // The fit for loose arrays and the Carman limit 10 s/e^3 of dense ones, blended by an exponential weight.
  static double creeping(double s, double linear, double a, double b, double c) {
    const double carman = 10.0 * s / std::pow(1.0 - s, 3);
    if (s >= 0.4) return carman;
    if (s <= 0.0) return 1.0;
    const double loose = (1.0 + 3.0 * std::sqrt(0.5 * s) + 135.0 / 64.0 * s * std::log(s) + linear * s) /
                         (1.0 + a * s + b * s * s + c * s * s * s);
    const double weight = std::exp(-10.0 * (0.4 - s) / s);
    return (1.0 - weight) * loose + weight * carman;
  }
};

}  // namespace slfb::drag
