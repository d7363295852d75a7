#pragma once

#include "correlations/fluidisation/minimum_fluidisation/packed_bed.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation::minimum_fluidisation {

/// Minimum fluidisation velocity from the pressure drop of Ergun (1952), Chem. Eng. Prog. 48, 89:
/// \f$ \frac{1.75}{\varepsilon^3} Re^2 + \frac{150 (1-\varepsilon)}{\varepsilon^3} Re = Ar \f$.
///
/// Range: packed beds, 1 < Re/(1 − ε) < 2500. Confidence: read in several codes.
struct Ergun1952 {
  static constexpr LawInfo info{.name = "ergun-1952-minimum-fluidisation",
                                .kind = LawKind::minimum_fluidisation,
                                .title = "Minimum fluidisation from the Ergun equation (1952)",
                                .equation = "1.75 Re^2/e^3 + 150 (1 - e) Re/e^3 = Ar",
                                .source = "ergun1952",
                                .convention = "Re = rho U_mf d / mu (superficial); e is the voidage of the packed bed",
                                .reynolds = {0.4, 1500.0},
                                .voidage = {0.3, 0.5},
                                .confidence = Confidence::read};

  /// \return U_mf [m/s]
  double operator()(const PackedBed& bed) const {
    const double e = bed.voidage;
    const double e3 = e * e * e;
    const double reynolds = positive_root(1.75 / e3, 150.0 * (1.0 - e) / e3, archimedes_number(bed.sphere, bed.liquid));
    return reynolds * bed.liquid.viscosity / (bed.liquid.density * bed.sphere.diameter);
  }
};

}  // namespace slfb::fluidisation::minimum_fluidisation
