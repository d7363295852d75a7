#pragma once

#include <cmath>

#include "correlations/fluidisation/minimum_fluidisation/packed_bed.hpp"
#include "correlations/law.hpp"

namespace slfb::fluidisation::minimum_fluidisation {

/// Minimum fluidisation velocity of Wen & Yu (1966), AIChE J. 12, 610:
/// \f$ Re = \sqrt{33.7^2 + 0.0408\,Ar} - 33.7 \f$, Ergun's equation with the voidage terms replaced by constants.
///
/// Range: 284 points with a standard deviation of 34 %, packed voidage 0.385 to 0.935. Confidence: read in a
/// transcription.
struct WenYu1966 {
  static constexpr LawInfo info{.name = "wen-yu-1966-minimum-fluidisation",
                                .kind = LawKind::minimum_fluidisation,
                                .title = "Minimum fluidisation, Wen & Yu (1966), no voidage needed",
                                .equation = "Re = sqrt(33.7^2 + 0.0408 Ar) - 33.7",
                                .source = "wenyu1966b",
                                .convention = "Re = rho U_mf d / mu (superficial); e is the voidage of the packed bed",
                                .reynolds = {0.001, 4e3},
                                .voidage = {0.385, 0.935},
                                .confidence = Confidence::read,
                                .note = "the voidage is not used"};

  /// \return U_mf [m/s]
  double operator()(const PackedBed& bed) const {
    const double archimedes = archimedes_number(bed.sphere, bed.liquid);
    const double reynolds = std::sqrt(33.7 * 33.7 + 0.0408 * archimedes) - 33.7;
    return reynolds * bed.liquid.viscosity / (bed.liquid.density * bed.sphere.diameter);
  }
};

}  // namespace slfb::fluidisation::minimum_fluidisation
