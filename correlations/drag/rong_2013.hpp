#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/single_sphere/dalla_valle_1948.hpp"

namespace slfb::drag {

/// Drag from lattice-Boltzmann simulations of packed beds, Rong, Dong & Yu (2013), Chem. Eng. Sci. 99, 44:
/// \f$ F = \tfrac{1}{24} C_D(Re)\,Re\;\varepsilon^{-B} \f$, \f$ B = 2.65 (\varepsilon + 1) - (5.3 - 3.5 \varepsilon)
/// \varepsilon^2 \exp[-\tfrac12 (1.5 - \log_{10} Re)^2] \f$, with \f$ C_D \f$ of Dalla Valle (1948).
///
/// Range: 0.37 ≤ ε ≤ 1, Re to about 3000. Confidence: read in PhasicFlow, which Lethe follows.
struct Rong2013 {
  static constexpr LawInfo info{
      .name = "rong-2013",
      .kind = LawKind::drag,
      .title = "Lattice Boltzmann, Rong, Dong & Yu (2013)",
      .equation =
          "F = (C_D Re/24) e^-B, C_D of Dalla Valle, B = 2.65 (e + 1) - (5.3 - 3.5 e) e^2 exp(-(1.5 - log10 Re)^2 / 2)",
      .source = "rong2013",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.0, 3e3},
      .voidage = {0.37, 1.0},
      .confidence = Confidence::read};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    using std::pow;
    return single_sphere::DallaValle1948{}(flow.reynolds) * pow(flow.voidage, -exponent(flow));
  }

 private:
  // As in Di Felice's law the dip around Re = 30 vanishes in the creeping-flow limit, where log10 has no value.
  template <class Number>
  static Number exponent(SuspensionFlowOf<Number> flow) {
    using std::exp, std::log10;
    const double e = flow.voidage;
    const double viscous = 2.65 * (e + 1.0);
    if (flow.reynolds <= 0.0) return viscous;
    const Number decades = 1.5 - log10(flow.reynolds);
    return viscous - (5.3 - 3.5 * e) * e * e * exp(-0.5 * decades * decades);
  }
};

}  // namespace slfb::drag
