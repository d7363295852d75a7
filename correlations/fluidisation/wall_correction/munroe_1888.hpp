#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Terminal velocity on the axis of a tube over that in unbounded liquid after Munroe (1888): u/u_t = 1 − (d/D)^1.5.
///
/// Range: Newton's regime, Re > 1000. Confidence: recalled.
struct Munroe1888 {
  static constexpr LawInfo info{
      .name = "munroe-1888",
      .kind = LawKind::wall_correction,
      .title = "Settling in a tube, Munroe (1888)",
      .equation = "u/u_t = 1 - r^1.5",
      .source = "munroe1888",
      .convention = "r = d/D, sphere over tube diameter; the law multiplies the terminal velocity in unbounded liquid",
      .reynolds = {1e3, std::numeric_limits<double>::infinity()},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::recalled};

  /// \param diameter_ratio d/D [-]
  /// \return u/u_t [-]
  double operator()(double diameter_ratio) const { return 1.0 - std::pow(diameter_ratio, 1.5); }
};

}  // namespace slfb::fluidisation
