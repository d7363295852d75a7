#pragma once

#include <limits>

#include "solver/dem/linear_spring_dashpot.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::dem {

/// Tangential spring and dashpot, limited by Coulomb friction (Cundall & Strack 1979; Tsuji et al. 1993).
///
/// F_t = −k_t ξ − c_t v_t, |F_t| ≤ μ max(F_n, 0), F_n without dashpot_end_correction(): the spring remembers where it
/// slid. A step adds Δt v_t to ξ; the part `phase` of it before the force is taken. 1 is right for symplectic Euler,
/// whose positions have moved with the newest velocity already; 1/2, the trapezoidal rule, for integrators that know
/// position and velocity at the same time. On sliding, ξ is set to the spring that carries the limit. With k_t = 0 the
/// dashpot acts alone.
struct CoulombFriction {
  double friction;  ///< μ [-]
  double phase;     ///< [-]

  /// Force on i [N]. `slip`: v_i − v_j at the contact, in its plane [m/s]; `spring`: ξ, carried from step to step [m].
  [[gnu::always_inline]] Vec3 operator()(const NormalContact& contact, Vec3 normal, Vec3 slip, double time_step,
                                         Vec3& spring) const {
    // The contact plane has turned with the pair since the last step: lay ξ into it and keep its length. The factor is
    // the series of 1/√(1 − q) with q the squared sine of the turn in one step.
    const double out_of_plane = dot(spring, normal);
    const double q = out_of_plane * out_of_plane / (dot(spring, spring) + std::numeric_limits<double>::min());
    const Vec3 turned = (1.0 + 0.5 * q) * (spring - out_of_plane * normal);
    const Vec3 stretched = turned + (phase * time_step) * slip;

    const Vec3 damping = contact.tangential_damping * slip;
    const Vec3 trial = contact.tangential_stiffness * stretched + damping;
    const double limit = friction * (contact.load > 0.0 ? contact.load : 0.0);
    const double trial_squared = dot(trial, trial);
    const bool slides = trial_squared > limit * limit;
    const double scale = slides ? limit / std::sqrt(trial_squared) : 1.0;
    const Vec3 force = -scale * trial;
    const double compliance = contact.tangential_stiffness > 0.0 ? 1.0 / contact.tangential_stiffness : 0.0;
    const Vec3 limited = -compliance * (force + damping);
    const Vec3 ahead = stretched + ((1.0 - phase) * time_step) * slip;
    spring = {slides ? limited.x : ahead.x, slides ? limited.y : ahead.y, slides ? limited.z : ahead.z};
    return force;
  }
};

}  // namespace slfb::dem
