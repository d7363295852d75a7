#pragma once

#include <array>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag in a packed bed after Ergun (1952), Chem. Eng. Prog. 48, 89:
/// \f$ F = \frac{150\,(1-\varepsilon)}{18\,\varepsilon^2} + \frac{1.75\,Re}{18\,\varepsilon^2} \f$,
/// the pressure drop of the packed bed shared out over its spheres.
///
/// Range: packed beds, 1 < Re/(1 − ε) < 2500; fluidised-bed codes use it to ε = 0.8. It has no single-sphere limit.
/// Confidence: read in MFIX and OpenFOAM.
struct Ergun1952 {
  static constexpr LawInfo info{
      .name = "ergun-1952",
      .kind = LawKind::drag,
      .title = "Packed bed, Ergun (1952)",
      .equation = "F = 150 (1 - e)/(18 e^2) + 1.75 Re/(18 e^2)",
      .equation_number = "Eq. 13c",
      .source = "ergun1952",
      .convention = "model A; Re = rho e d w / mu (superficial slip)",
      .reynolds = {0.4, 1500.0},
      .voidage = {0.3, 0.5},
      .confidence = Confidence::read,
      .note = "range of Re is that of Re/(1 - e), 1 to 2500, at e = 0.4 to 0.6; no single-sphere limit"};

  double viscous = 150.0;
  double inertial = 1.75;

  static constexpr auto parameters() {
    return std::array{
        LawParameter<Ergun1952>{"viscous", &Ergun1952::viscous, {0.0, 1000.0}, "constant of the viscous part"},
        LawParameter<Ergun1952>{"inertial", &Ergun1952::inertial, {0.0, 100.0}, "constant of the inertial part"}};
  }

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const double e = flow.voidage;
    return (viscous * (1.0 - e) + inertial * flow.reynolds) / (18.0 * e * e);
  }
};

}  // namespace slfb::drag
