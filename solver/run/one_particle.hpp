#pragma once

#include <string>
#include <vector>

namespace slfb {

/// One sphere that moves vertically through a uniform suspension or plain liquid: more than a correlation, less than
/// the discrete element method.
struct OneParticleFall {
  double diameter = 0.0;             ///< [m]
  double density = 0.0;              ///< [kg/m³]
  double liquid_density = 0.0;       ///< [kg/m³]
  double viscosity = 0.0;            ///< [Pa s]
  double liquid_velocity = 0.0;      ///< interstitial, upwards [m/s]
  double voidage = 1.0;              ///< seen by the drag law [-]
  double surrounding_density = 0.0;  ///< whose weight gives the buoyancy: liquid or mixture [kg/m³]
  double added_mass = 0.0;    ///< coefficient of the displaced liquid's mass, 0.5 for a sphere in potential flow [-]
  double wall_drag = 0.0;     ///< what side walls at rest add to the drag, over Stokes drag (Fayon & Happel 1960) [-]
  bool above_bottom = false;  ///< a bottom at height 0 holds the sphere up (Brenner 1961)
  std::string drag_law = "wen-yu-1966";
  double height = 0.0;    ///< of the centre at t = 0 [m]
  double velocity = 0.0;  ///< at t = 0, upwards [m/s]
};

struct FallState {
  double time, height, velocity;  ///< [s], [m], [m/s]
};

/// Solves (m + C ρ V) dv/dt = −(ρ_p − ρ_s) V g + V β/(1 − ε) (u − v) − 3 π μ d (K_wall + λ(h/r) − 1) v, dz/dt = v, by
/// CVODE (BDF, relative tolerance 1e-10).
///
/// What walls add is taken from Stokes flow and added to the drag at any Re, as Fayon & Happel (1960) found for tubes
/// of up to about Re = 40; λ is Brenner's series in the gap h = z − r over a bottom, 1 without one. Keys: fayon1960,
/// brenner1961. The history force is not in it.
///
/// \param times increasing output times [s]; the first state is that at times.front()
/// \throws std::runtime_error if CVODE fails, as it does once the gap over a bottom is lost in the rounding of the
/// height, std::invalid_argument for an unknown drag law
std::vector<FallState> integrate_fall(const OneParticleFall& fall, const std::vector<double>& times);

}  // namespace slfb
