#pragma once

#include "correlations/drag/drag_law.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/root.hpp"

namespace slfb::classification {

/// Settling velocity [m/s] of a foreign sphere that meets no other sphere: its weight, less the pressure gradient of
/// the bed (ρ_M g), is carried by the drag alone. It is the upper limit of any classification velocity that the law
/// gives. \param law a drag law of the suite \throws std::domain_error if no slip below 3 m/s balances
template <class Law>
double force_balance_velocity(const Law& law, const ForeignSphereInBed& state) {
  const double apparent_weight = (state.foreign.density - state.mixture_density()) * gravitational_acceleration;
  const double slip = bracketed_root(
      [&](double trial) {
        const double reynolds = reynolds_number(state.liquid, state.foreign.diameter, state.voidage * trial);
        return trial * drag::exchange_per_solid_volume(law(drag::SuspensionFlow{state.voidage, reynolds}),
                                                       state.voidage, state.foreign.diameter, state.liquid.viscosity) -
               apparent_weight;
      },
      0.0, 3.0, "slip velocity [m/s]");
  return slip - state.interstitial_velocity();
}

}  // namespace slfb::classification
