#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Schiller & Naumann (1935), continued by Newton's constant as in Peng 2014, Eq. 24:
/// \f$ C_D = \frac{24}{Re}\,(1 + 0.15\,Re^{0.687}) \f$ for Re ≤ 1000, and 0.44 above.
///
/// Range: Re ≤ 1000 for the power law; the constant holds to about 2e5. C_D steps from 0.4383 to 0.44 at Re = 1000.
/// Confidence: read in MFIX and OpenFOAM.
struct SchillerNaumann1935 {
  static constexpr LawInfo info{
      .name = "schiller-naumann-1935",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Schiller & Naumann (1935)",
      .equation = "C_D = 24/Re (1 + 0.15 Re^0.687) for Re <= 1000; C_D = 0.44 above",
      .equation_number = "Peng 2014, Eq. 24",
      .source = "schiller1935",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 2e5},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read,
      .note = "Eq. 24 of Peng 2014: the constant 0.44 above Re = 1000 is not part of the 1935 fit"};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::pow;
    if (reynolds > 1000.0) return 0.44 * reynolds / 24.0;
    return 1.0 + 0.15 * pow(reynolds, 0.687);
  }
};

}  // namespace slfb::drag::single_sphere
