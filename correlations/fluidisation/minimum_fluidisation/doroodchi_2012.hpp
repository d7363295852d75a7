#pragma once

#include <cmath>

#include "correlations/fluidisation/minimum_fluidisation/packed_bed.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation::minimum_fluidisation {

/// Minimum fluidisation velocity from
/// \f$ (\rho_P - \rho) g\,\varepsilon^{4.8} = 18\,\mu U/d^2 + 0.33\,\rho U^2/d \f$.
///
/// Source and confidence: Eq. 36 of Peng 2014, there after Doroodchi et al. (2012); its terms were settled by their
/// limits: 18 is Stokes, 0.33 is ¾ · 0.44.
struct Doroodchi2012 {
  static constexpr LawInfo info{.name = "doroodchi-2012-minimum-fluidisation",
                                .kind = LawKind::minimum_fluidisation,
                                .title = "Minimum fluidisation, Doroodchi et al. (2012), Peng Eq. 36",
                                .equation = "(rho_P - rho) g e^4.8 = 18 mu U/d^2 + 0.33 rho U^2/d",
                                .equation_number = "Peng 2014, Eq. 36",
                                .source = "doroodchi2012",
                                .convention = "Re = rho U_mf d / mu (superficial); e is the voidage of the packed bed",
                                .reynolds = {0.0, 1e4},
                                .voidage = {0.35, 1.0},
                                .confidence = Confidence::derived};

  /// \return U_mf [m/s]
  double operator()(const PackedBed& bed) const {
    const double weight = archimedes_number(bed.sphere, bed.liquid) * std::pow(bed.voidage, 4.8);
    const double reynolds = positive_root(0.33, 18.0, weight);
    return reynolds * bed.liquid.viscosity / (bed.liquid.density * bed.sphere.diameter);
  }
};

}  // namespace slfb::fluidisation::minimum_fluidisation
