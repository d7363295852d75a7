#pragma once

#include <cmath>
#include <numbers>

namespace slfb::collision {

/// One foreign sphere among the spheres of a bed, as the laws for the collision frequency see it.
struct CollisionState {
  double solids;            ///< α_S of the bed [-]
  double bed_diameter;      ///< d_1 [m]
  double foreign_diameter;  ///< d_2 [m]
  double kinetic_energy;    ///< q_p² = (3/2)⟨u_p'²⟩, u_p' one velocity component of the particles [m²/s²]
  double relative_velocity = 0.0;       ///< U_r, drift of the foreign sphere through the bed [m/s]
  double contact_value = 1.0;           ///< g_0 at this solids fraction [-]
  double foreign_kinetic_energy = 0.0;  ///< q² of the foreign sphere, for the law of unlike fluctuations [m²/s²]

  [[nodiscard]] double bed_number_density() const {
    return 6.0 * solids / (std::numbers::pi * bed_diameter * bed_diameter * bed_diameter);
  }
  [[nodiscard]] double contact_distance() const { return 0.5 * (bed_diameter + foreign_diameter); }
};

/// f* = f d_1 / √(q_p²) [-], Eq. 38 of Peng 2014.
inline double dimensionless_frequency(double frequency, const CollisionState& state) {
  return frequency * state.bed_diameter / std::sqrt(state.kinetic_energy);
}

}  // namespace slfb::collision
