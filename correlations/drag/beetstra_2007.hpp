#pragma once

#include <cmath>

#include "correlations/drag/drag_law.hpp"

namespace slfb::drag {

/// Drag from lattice-Boltzmann simulations of random arrays, Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53, 489.
/// With s = 1 − ε: \f$ F = \frac{10 s}{\varepsilon^2} + \varepsilon^2 (1 + 1.5\sqrt{s}) +
/// \frac{0.413\,Re}{24\,\varepsilon^2} \frac{\varepsilon^{-1} + 3 \varepsilon s + 8.4 Re^{-0.343}}{1 + 10^{3s}
/// Re^{-(1+4s)/2}} \f$.
///
/// Range: 0.1 < s < 0.6, Re < 1000. Confidence: read in MFIX, OpenFOAM and CFDEM, which agree.
struct Beetstra2007 {
  static constexpr LawInfo info{.name = "beetstra-2007",
                                .kind = LawKind::drag,
                                .title = "Lattice Boltzmann, Beetstra, van der Hoef & Kuipers (2007)",
                                .equation =
                                    "F = 10 s/e^2 + e^2 (1 + 1.5 sqrt(s)) + 0.413 Re/(24 e^2) (1/e + 3 e s + 8.4 "
                                    "Re^-0.343)/(1 + 10^(3s) Re^-((1+4s)/2))",
                                .source = "beetstra2007",
                                .convention = "model A; Re = rho e d w / mu (superficial slip)",
                                .reynolds = {0.0, 1e3},
                                .voidage = {0.4, 0.9},
                                .confidence = Confidence::read};

  /// \param flow voidage ε [-] and superficial slip Reynolds number Re = ρ ε d w / μ [-]
  /// \return F = f_d / (3 π μ d ε w) [-]
  template <class Number = double>
  Number operator()(SuspensionFlowOf<Number> flow) const {
    using std::pow;
    const double e = flow.voidage;
    const double s = 1.0 - e;
    const double creeping = 10.0 * s / (e * e) + e * e * (1.0 + 1.5 * std::sqrt(s));
    // Both powers of Re are written with positive exponents, so that Re = 0 gives the creeping-flow value.
    const Number inertial = (1.0 / e + 3.0 * e * s) * flow.reynolds + 8.4 * pow(flow.reynolds, 0.657);
    const Number onset = pow(flow.reynolds, 0.5 + 2.0 * s);
    return creeping + 0.413 / (24.0 * e * e) * inertial * onset / (onset + std::pow(10.0, 3.0 * s));
  }
};

}  // namespace slfb::drag
