#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::fluidisation {

/// Terminal velocity on the axis of a tube over that in unbounded liquid in Stokes flow after Haberman & Sayre (1958):
/// \f$ u/u_t = \frac{1 - 2.105 r + 2.0865 r^3 - 1.7068 r^5 + 0.72603 r^6}{1 - 0.75857 r^5} \f$ with r = d/D.
///
/// Its inverse is the drag over Stokes drag. Range: Stokes flow, r < 0.5. A square duct of side L has the same first
/// term for D = 1.106 L (Happel & Bart 1974: 1.903 d/L). Confidence: recalled; it gives the report's table to
/// r = 0.3, and 1.7 % less drag at 0.5.
struct HabermanSayre1958 {
  static constexpr LawInfo info{
      .name = "haberman-sayre-1958",
      .kind = LawKind::wall_correction,
      .title = "Settling in a tube in Stokes flow, Haberman & Sayre (1958)",
      .equation = "u/u_t = (1 - 2.105 r + 2.0865 r^3 - 1.7068 r^5 + 0.72603 r^6)/(1 - 0.75857 r^5)",
      .source = "haberman1958",
      .convention = "r = d/D, sphere over tube diameter; the law multiplies the terminal velocity in unbounded liquid",
      .reynolds = {0.0, 0.1},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::recalled};

  /// \param diameter_ratio d/D [-]
  /// \return u/u_t [-]
  double operator()(double diameter_ratio) const {
    const double r = diameter_ratio, r3 = r * r * r, r5 = r3 * r * r;
    return (1.0 - 2.105 * r + 2.0865 * r3 - 1.7068 * r5 + 0.72603 * r5 * r) / (1.0 - 0.75857 * r5);
  }
};

}  // namespace slfb::fluidisation
