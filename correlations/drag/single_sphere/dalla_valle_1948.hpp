#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Dalla Valle (1948), "Micromeritics":
/// \f$ C_D = (0.63 + 4.8 / \sqrt{Re})^2 \f$.
///
/// Range: Re < 3000. As Re → 0 it tends to 23.04/Re, 4 % below Stokes. Confidence: read in MFIX, CFDEM and OpenFOAM.
struct DallaValle1948 {
  static constexpr LawInfo info{
      .name = "dalla-valle-1948",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Dalla Valle (1948)",
      .equation = "C_D = (0.63 + 4.8/sqrt(Re))^2",
      .source = "dallavalle1948",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 3e3},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::read,
      .note = "Stokes limit 23.04/Re instead of 24/Re"};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 0.96 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::sqrt;
    const Number root = 0.63 * sqrt(reynolds) + 4.8;
    return root * root / 24.0;
  }
};

}  // namespace slfb::drag::single_sphere
