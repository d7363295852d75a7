#pragma once

#include <cmath>

#include "correlations/drag/di_felice_1994.hpp"
#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/single_sphere/schiller_naumann_1935.hpp"

namespace slfb::drag {

/// Di Felice's voidage function with the single-sphere drag that MFIX puts under it:
/// \f$ F = \tfrac{1}{24} C_D(Re)\,Re\;\varepsilon^{-\chi} \f$ with \f$ C_D \f$ of Schiller & Naumann (1935) in place of
/// Dalla Valle (1948).
///
/// Range: that of di-felice-1994. Confidence: read in MFIX.
struct DiFelice1994Mfix {
  static constexpr LawInfo info{
      .name = "di-felice-1994-mfix",
      .kind = LawKind::drag,
      .title = "Voidage function of Di Felice (1994) on Schiller-Naumann, as in MFIX",
      .equation = "F = (C_D Re/24) e^-X, C_D of Schiller-Naumann, X = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2)",
      .source = "difelice1994",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.01, 1e4},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::read,
      .variant_of = "di-felice-1994"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    using std::pow;
    return single_sphere::SchillerNaumann1935{}(flow.reynolds) *
           pow(flow.voidage, -DiFelice1994{}.exponent(flow.reynolds));
  }
};

}  // namespace slfb::drag
