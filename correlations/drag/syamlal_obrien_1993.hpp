#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"
#include "correlations/drag/single_sphere/dalla_valle_1948.hpp"

namespace slfb::drag {

/// Drag from the terminal velocity of a sphere in its suspension, Syamlal, Rogers & O'Brien (1993), MFIX Theory Guide,
/// Eqs. 11–16: \f$ F = \frac{C_D(Re_m/V_r)\,Re_m}{24\,V_r^2} \f$ with \f$ Re_m = Re/\varepsilon \f$,
/// \f$ V_r = \tfrac12 [A - 0.06 Re_m + \sqrt{(0.06 Re_m)^2 + 0.12 Re_m (2B - A) + A^2}] \f$, \f$ A = \varepsilon^{4.14}
/// \f$, \f$ B = 0.8\,\varepsilon^{1.28} \f$ for ε ≤ 0.85 and \f$ \varepsilon^{2.65} \f$ above; C_D of Dalla Valle
/// (1948).
///
/// Range: all voidages. The Stokes limit is 23.04/Re; F steps down by under 1 % at ε = 0.85. Confidence: read in MFIX
/// and OpenFOAM.
struct SyamlalOBrien1993 {
  static constexpr LawInfo info{
      .name = "syamlal-obrien-1993",
      .kind = LawKind::drag,
      .title = "From the terminal velocity of suspensions, Syamlal & O'Brien (1993)",
      .equation = "F = C_D(Rm/Vr) Rm/(24 Vr^2), Rm = Re/e, C_D of Dalla Valle, Vr of Garside & Al-Dibouni",
      .equation_number = "Eqs. 11-16",
      .source = "syamlal1993",
      .convention = "model A; Re = rho e d w / mu (superficial slip); the source uses the interstitial Rm = Re/e",
      .reynolds = {0.0, 1e4},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::read,
      .note =
          "V_r is the terminal velocity in the suspension over that of the single sphere (Garside & Al-Dibouni 1977)"};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    const Number interstitial = flow.reynolds / flow.voidage;
    const Number ratio = velocity_ratio(flow.voidage, interstitial);
    return single_sphere::DallaValle1948{}(interstitial / ratio) / ratio;
  }

  /// Terminal velocity in the suspension over that of the single sphere [-], at the interstitial Reynolds number.
  template <class Number>
  static Number velocity_ratio(double voidage, Number interstitial_reynolds) {
    using std::sqrt;
    const double viscous = std::pow(voidage, 4.14);
    const double inertial = voidage <= 0.85 ? 0.8 * std::pow(voidage, 1.28) : std::pow(voidage, 2.65);
    const Number r = 0.06 * interstitial_reynolds;
    return 0.5 * (viscous - r + sqrt(r * r + 2.0 * r * (2.0 * inertial - viscous) + viscous * viscous));
  }
};

}  // namespace slfb::drag
