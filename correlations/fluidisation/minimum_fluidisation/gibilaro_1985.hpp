#pragma once

#include <cmath>

#include "correlations/fluidisation/minimum_fluidisation/packed_bed.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation::minimum_fluidisation {

/// Minimum fluidisation velocity from
/// \f$ (\rho_P - \rho) g\,\varepsilon^{4.8} = 17.3\,\mu U/d^2 + 0.336\,\rho U^2/d \f$.
///
/// Source and confidence: Gibilaro, Di Felice, Waldram & Foscolo (1985), Chem. Eng. Sci. 40, 1817, read in OpenFOAM and
/// in a review table.
struct Gibilaro1985 {
  static constexpr LawInfo info{.name = "gibilaro-1985-minimum-fluidisation",
                                .kind = LawKind::minimum_fluidisation,
                                .title = "Minimum fluidisation, Gibilaro et al. (1985)",
                                .equation = "(rho_P - rho) g e^4.8 = 17.3 mu U/d^2 + 0.336 rho U^2/d",
                                .source = "gibilaro1985",
                                .convention = "Re = rho U_mf d / mu (superficial); e is the voidage of the packed bed",
                                .reynolds = {0.0, 1e4},
                                .voidage = {0.35, 1.0},
                                .confidence = Confidence::read};

  /// \return U_mf [m/s]
  double operator()(const PackedBed& bed) const {
    const double weight = archimedes_number(bed.sphere, bed.liquid) * std::pow(bed.voidage, 4.8);
    const double reynolds = positive_root(0.336, 17.3, weight);
    return reynolds * bed.liquid.viscosity / (bed.liquid.density * bed.sphere.diameter);
  }
};

}  // namespace slfb::fluidisation::minimum_fluidisation
