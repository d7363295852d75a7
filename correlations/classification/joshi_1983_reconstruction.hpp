#pragma once

#include <limits>

#include "correlations/fluidisation/minimum_fluidisation/doroodchi_2012.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::classification {

/// Classification velocity, RECONSTRUCTION of Joshi (1983), Chem. Eng. Res. Des. 61, 143. The original formula is not
/// at hand.
///
/// The stand-in applies the energy-balance law behind Eq. 36 of Peng 2014 to the foreign sphere at the voidage of the
/// bed: \f$ (\rho_2 - \rho) g\,\varepsilon^{4.8} = 18 \mu W/d_2^2 + 0.33 \rho W^2/d_2 \f$, \f$ V_2 = (W -
/// U_L)/\varepsilon \f$. It behaves as Peng 2014 says of Joshi's law: good in a dilute bed, far too fast at U_L = 0.06
/// m/s.
struct Joshi1983Reconstruction {
  static constexpr LawInfo info{
      .name = "joshi-1983-reconstruction",
      .kind = LawKind::classification,
      .title = "Classification velocity, reconstruction of Joshi (1983)",
      .equation = "(rho_2 - rho) g e^4.8 = 18 mu W/d2^2 + 0.33 rho W^2/d2; V2 = (W - U_L)/e",
      .source = "joshi1983",
      .convention = "V2 downwards in the laboratory; W is the superficial slip velocity of the foreign sphere",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::reconstructed,
      .note = "a labelled reconstruction: the original formula was not at hand"};

  /// \return V_2 [m/s], downwards in the laboratory
  double operator()(const ForeignSphereInBed& state) const {
    const double superficial_slip = fluidisation::minimum_fluidisation::Doroodchi2012{}(
        {.sphere = state.foreign, .liquid = state.liquid, .voidage = state.voidage});
    return (superficial_slip - state.superficial_velocity) / state.voidage;
  }
};

}  // namespace slfb::classification
