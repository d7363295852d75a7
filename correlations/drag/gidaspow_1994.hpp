#pragma once

#include <array>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/ergun_1952.hpp"
#include "correlations/drag/wen_yu_1966.hpp"

namespace slfb::drag {

/// Drag after Gidaspow (1994), "Multiphase Flow and Fluidization"; Eqs. 23–25 of Peng 2014:
/// Ergun (1952) for ε ≤ 0.8 and Wen & Yu (1966) for ε > 0.8.
///
/// The law jumps at ε = 0.8: by a factor of 1.06 at Re = 10 and 3.75 at Re = 1000. A homogeneous bed of 5 mm glass in
/// water therefore has no steady voidage between 0.131 and 0.255 m/s. Confidence: read in MFIX and OpenFOAM.
struct Gidaspow1994 {
  static constexpr LawInfo info{.name = "gidaspow-1994",
                                .kind = LawKind::drag,
                                .title = "Ergun and Wen-Yu switched at voidage 0.8, Gidaspow (1994)",
                                .equation = "F = Ergun for e <= 0.8, Wen-Yu for e > 0.8",
                                .equation_number = "Peng 2014, Eqs. 23-25",
                                .source = "gidaspow1994",
                                .convention = "model A; Re = rho e d w / mu (superficial slip)",
                                .reynolds = {0.0, 2e5},
                                .voidage = {0.3, 1.0},
                                .confidence = Confidence::read,
                                .note = "discontinuous at e = 0.8"};

  double viscous = Ergun1952{}.viscous;
  double inertial = Ergun1952{}.inertial;
  double exponent = WenYu1966{}.exponent;
  double switch_voidage = 0.8;

  static constexpr auto parameters() {
    using Parameter = LawParameter<Gidaspow1994>;
    return std::array{
        Parameter{"viscous", &Gidaspow1994::viscous, {0.0, 1000.0}, "of Ergun's viscous part"},
        Parameter{"inertial", &Gidaspow1994::inertial, {0.0, 100.0}, "of Ergun's inertial part"},
        Parameter{"exponent", &Gidaspow1994::exponent, {0.0, 10.0}, "of Wen & Yu's e^-exponent"},
        Parameter{"switch_voidage", &Gidaspow1994::switch_voidage, {0.0, 1.0}, "largest voidage with Ergun's law"}};
  }

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    return flow.voidage <= switch_voidage ? Ergun1952{viscous, inertial}(flow) : WenYu1966{exponent}(flow);
  }
};

}  // namespace slfb::drag
