#pragma once

#include <limits>

#include "correlations/collision/radial_distribution/carnahan_starling_1969.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// Pair distribution at contact after Torquato (1995), Phys. Rev. E 51, 3170: Carnahan–Starling up to freezing at
/// α_f = 0.494, then \f$ g_0(\alpha_f)\,\frac{\alpha_c - \alpha_f}{\alpha_c - \alpha_S} \f$ towards random close
/// packing α_c = 0.64.
///
/// Range: α_S < 0.64. Confidence: recalled.
struct Torquato1995 {
  static constexpr LawInfo info{
      .name = "torquato-1995",
      .kind = LawKind::radial_distribution,
      .title = "Contact value of the pair distribution, Torquato (1995)",
      .equation = "g0 = Carnahan-Starling for a <= 0.494, then g0(0.494) (0.64 - 0.494)/(0.64 - a)",
      .source = "torquato1995",
      .convention = "a = 1 - e is the solids fraction",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.36, 1.0},
      .confidence = Confidence::recalled};

  /// \param solids solids fraction α_S [-]
  /// \return g_0 [-]; infinite from the packing on
  double operator()(double solids) const {
    constexpr double freezing = 0.494;
    constexpr double close_packing = 0.64;
    const CarnahanStarling1969 fluid;
    if (solids <= freezing) return fluid(solids);
    if (solids >= close_packing) return std::numeric_limits<double>::infinity();
    return fluid(freezing) * (close_packing - freezing) / (close_packing - solids);
  }
};

}  // namespace slfb::collision
