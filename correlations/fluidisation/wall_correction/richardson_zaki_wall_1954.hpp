#pragma once

#include <cmath>
#include <limits>

#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Intercept of a fluidised bed's expansion line over the terminal velocity of one sphere after Richardson & Zaki
/// (1954), Eq. 41: U_i/u_t = 10^(−d/D).
///
/// Range: d/D < 0.04. It describes a bed, not one sphere, and reduces far more than the other two laws. Confidence:
/// recalled for this use; the equation was read in a transcription.
struct RichardsonZakiWall1954 {
  static constexpr LawInfo info{
      .name = "richardson-zaki-1954-wall",
      .kind = LawKind::wall_correction,
      .title = "Intercept of fluidisation in a tube, Richardson & Zaki (1954), Eq. 41",
      .equation = "U_i/u_t = 10^-r",
      .equation_number = "Eq. 41",
      .source = "richardson1954",
      .convention = "r = d/D, sphere over tube diameter; the law multiplies the terminal velocity in unbounded liquid",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::recalled,
      .note = "the three wall laws disagree strongly: 0.958, 0.982 and 0.759 at d/D = 0.12",
      .size_ratio = {0.0, 0.04}};

  /// \param diameter_ratio d/D [-]
  /// \return u/u_t [-]
  double operator()(double diameter_ratio) const { return std::pow(10.0, -diameter_ratio); }
};

}  // namespace slfb::fluidisation
