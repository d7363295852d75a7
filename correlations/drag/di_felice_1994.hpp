#pragma once

#include <array>
#include <cmath>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/single_sphere/dalla_valle_1948.hpp"

namespace slfb::drag {

/// Drag in a suspension after Di Felice (1994), Int. J. Multiphase Flow 20, 153:
/// \f$ F = \tfrac{1}{24} C_D(Re)\,Re\;\varepsilon^{-\chi} \f$,
/// \f$ \chi = 3.7 - 0.65 \exp[-\tfrac12 (1.5 - \log_{10} Re)^2] \f$, with \f$ C_D \f$ of Dalla Valle (1948).
///
/// Range: 0.01 < Re < 1e4, from the packed bed to the single sphere. Confidence: read in CFDEM (MFIX puts the C_D of
/// Schiller–Naumann in its place).
struct DiFelice1994 {
  static constexpr LawInfo info{
      .name = "di-felice-1994",
      .kind = LawKind::drag,
      .title = "Voidage function, Di Felice (1994)",
      .equation = "F = (C_D Re/24) e^-X, C_D of Dalla Valle, X = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2)",
      .source = "difelice1994",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.01, 1e4},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::read,
      .note = "the source writes the exponent for the total force with 1 - X; this is the drag of model A"};

  double limit = 3.7;
  double dip = 0.65;

  static constexpr auto parameters() {
    return std::array{
        LawParameter<DiFelice1994>{"limit", &DiFelice1994::limit, {0.0, 10.0}, "exponent X at small and large Re"},
        LawParameter<DiFelice1994>{"dip", &DiFelice1994::dip, {0.0, 5.0}, "how much less X is at Re = 10^1.5"}};
  }

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    using std::pow;
    return single_sphere::DallaValle1948{}(flow.reynolds) * pow(flow.voidage, -exponent(flow.reynolds));
  }

  /// χ [-]. The dip of the exponent around Re = 30 is gone in the creeping-flow limit, where log10 has no value.
  template <class Number>
  Number exponent(Number reynolds) const {
    using std::exp, std::log10;
    if (reynolds <= 0.0) return limit;
    const Number decades = 1.5 - log10(reynolds);
    return limit - dip * exp(-0.5 * decades * decades);
  }
};

}  // namespace slfb::drag
