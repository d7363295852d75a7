#pragma once

#include <array>
#include <cmath>

#include "correlations/fluidisation/expansion_exponent/expansion_conditions.hpp"
#include "correlations/law.hpp"
#include "correlations/law_parameters.hpp"

namespace slfb::fluidisation {

/// Exponent of the bed expansion after Richardson & Zaki (1954), Trans. Inst. Chem. Eng. 32, 35, Eqs. 33–39:
/// n = 4.65 + 19.5 d/D for Re_t < 0.2, (4.35 + 17.5 d/D) Re_t^−0.03 to 1, (4.45 + 18 d/D) Re_t^−0.1 to 200,
/// 4.45 Re_t^−0.1 to 500 and 2.39 above.
///
/// In fluidisation the intercept is U_i = u_t 10^(−d/D) (Eq. 41). Range: 2e-4 < Re_t < 7e3, d/D < 0.04. Jumps by up to
/// 14 % at Re_t = 200 when d/D is large. Confidence: read in a transcription of the 1997 reprint.
struct RichardsonZaki1954 {
  static constexpr LawInfo info{.name = "richardson-zaki-1954",
                                .kind = LawKind::expansion_exponent,
                                .title = "Expansion exponent, Richardson & Zaki (1954)",
                                .equation =
                                    "n = 4.65 + 19.5 d/D; (4.35 + 17.5 d/D) Re_t^-0.03; (4.45 + 18 d/D) Re_t^-0.1; "
                                    "4.45 Re_t^-0.1; 2.39 from Re_t 0.2, 1, 200, 500",
                                .equation_number = "Eqs. 33-39",
                                .source = "richardson1954",
                                .convention = "Re_t = rho u_t d / mu on the terminal velocity; U = U_i e^n",
                                .reynolds = {2e-4, 7e3},
                                .voidage = {0.4, 1.0},
                                .confidence = Confidence::read,
                                .note = "stated for d/D < 0.04; the bed of Peng 2014 has 0.06 to 0.1",
                                .size_ratio = {0.0, 0.04}};

  double n = 0.0;  ///< in place of the formula; 0: by the formula

  static constexpr auto parameters() {
    return std::array{LawParameter<RichardsonZaki1954>{
        "n", &RichardsonZaki1954::n, {0.0, 10.0}, "a constant exponent in place of the formula; 0: by the formula"}};
  }

  /// \return n [-]
  double operator()(const ExpansionConditions& conditions) const {
    if (n > 0.0) return n;
    const double re = conditions.terminal_reynolds;
    const double wall = conditions.diameter_ratio;
    if (re < 0.2) return 4.65 + 19.5 * wall;
    if (re < 1.0) return (4.35 + 17.5 * wall) * std::pow(re, -0.03);
    if (re < 200.0) return (4.45 + 18.0 * wall) * std::pow(re, -0.1);
    if (re < 500.0) return 4.45 * std::pow(re, -0.1);
    return 2.39;
  }
};

}  // namespace slfb::fluidisation
