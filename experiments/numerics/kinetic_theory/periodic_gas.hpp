#pragma once

/// The gas that kinetic theory speaks of, made with the particle engine.
namespace slfb::kinetic {

struct MeasuredFrequency {
  double value, error;      ///< f* = f d/√(q_p²), of one standard deviation of the mean of 20 stretches [-]
  double contact_fraction;  ///< t_c f [-]
  double energy_change;     ///< largest, over the energy at the start [-]
};

/// Elastic smooth spheres in a periodic cube, counted over a number of collisions of each.
/// \param solids fraction of the cube in spheres, 0.05 to 0.5 [-]
/// \param side side³ spheres
/// \param collisions of each sphere, in the mean
///
/// Soft spheres overlap by √(π/2) √(mΘ/k) in the mean (Barker & Henderson 1967), which is t_c f/(24 α_S g_0) diameters:
/// at t_c f = 0.004 this lowers the frequency by less than 0.2 % at any α_S here. A lattice at random velocities melts
/// in twenty collisions with ten times longer contacts, then forgets them in five.
MeasuredFrequency measure_frequency(double solids, int side, double collisions);

}  // namespace slfb::kinetic
