#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Terminal velocity on the axis of a tube over that in unbounded liquid after Newton (1687):
/// \f$ u/u_t = (1 - r^2)\sqrt{1 - r^2/2} \f$ with r = d/D.
///
/// Range: Newton's regime, Re > 1000. Confidence: recalled.
struct Newton1687 {
  static constexpr LawInfo info{
      .name = "newton-1687",
      .kind = LawKind::wall_correction,
      .title = "Settling in a tube, Newton (1687)",
      .equation = "u/u_t = (1 - r^2) sqrt(1 - r^2/2)",
      .source = "newton1687",
      .convention = "r = d/D, sphere over tube diameter; the law multiplies the terminal velocity in unbounded liquid",
      .reynolds = {1e3, std::numeric_limits<double>::infinity()},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::recalled};

  /// \param diameter_ratio d/D [-]
  /// \return u/u_t [-]
  double operator()(double diameter_ratio) const {
    const double area_ratio = diameter_ratio * diameter_ratio;
    return (1.0 - area_ratio) * std::sqrt(1.0 - 0.5 * area_ratio);
  }
};

}  // namespace slfb::fluidisation
