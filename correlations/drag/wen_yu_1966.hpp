#pragma once

#include <array>
#include <cmath>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/single_sphere/schiller_naumann_1935.hpp"

namespace slfb::drag {

/// Drag in a fluidised bed after Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100:
/// \f$ F = \tfrac{1}{24} C_D(Re)\,Re\;\varepsilon^{-3.65} \f$ with the single-sphere \f$ C_D \f$ of Eq. 24 of Peng
/// 2014.
///
/// Written for the drag per bed volume the exponent reads −2.65; both are the same law. Range: dilute to dense; codes
/// use it for ε > 0.8. Confidence: read in MFIX and OpenFOAM.
struct WenYu1966 {
  static constexpr LawInfo info{.name = "wen-yu-1966",
                                .kind = LawKind::drag,
                                .title = "Fluidised bed, Wen & Yu (1966)",
                                .equation = "F = (C_D Re/24) e^-3.65 with C_D of Schiller-Naumann (Eq. 24)",
                                .equation_number = "Peng 2014, Eqs. 23-24",
                                .source = "wenyu1966a",
                                .convention = "model A; Re = rho e d w / mu (superficial slip)",
                                .reynolds = {0.0, 2e5},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::read,
                                .note = "exponent -3.65 here is the -2.65 of Eq. 23, which multiplies e (1 - e) w"};

  double exponent = 3.65;

  static constexpr auto parameters() {
    return std::array{LawParameter<WenYu1966>{"exponent",
                                              &WenYu1966::exponent,
                                              {0.0, 10.0},
                                              "of e^-exponent, 1 more than where the drag per volume is written"}};
  }

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    return single_sphere::SchillerNaumann1935{}(flow.reynolds) * std::pow(flow.voidage, -exponent);
  }
};

}  // namespace slfb::drag
