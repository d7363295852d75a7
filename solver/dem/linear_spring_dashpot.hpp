#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/dem/vec3.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::dem {

/// Geometry and motion of a touching pair, seen from body i; a wall is a body j at rest.
struct ContactState {
  Vec3 normal;                 ///< unit vector from i to j
  double overlap;              ///< > 0 [m]
  Vec3 relative_velocity;      ///< v_i − v_j at the contact point, spin included [m/s]
  double root_effective_mass;  ///< √(m_i m_j / (m_i + m_j)), or √m_i at a wall [kg^½]
};

struct ContactForce {
  Vec3 force;       ///< on i [N]
  Vec3 tangential;  ///< its tangential part, which makes the torque [N]
  double normal;    ///< magnitude of the normal part, compressive positive [N]
};

/// Linear spring-dashpot contact with Coulomb friction and tangential history (Tsuji et al. 1993; Peng 2014, §3.1).
///
/// F_n = −(k_n δ + c_n v_n) n with c_n = 2 ζ √(k_n m_eff), ζ = −ln e / √(π² + ln² e): a damped oscillator, whose
/// half period returns e times the impact speed. The force may become tensile just before separation; cutting it off
/// would raise e. F_t = −k_t ξ − c_t v_t, |F_t| ≤ μ max(F_n, 0); on sliding, ξ is set back to the spring that carries
/// the limit.
class LinearSpringDashpot {
 public:
  LinearSpringDashpot() = default;
  explicit LinearSpringDashpot(const Contact& contact)
      : stiffness_(contact.stiffness),
        tangential_stiffness_(contact.stiffness * contact.tangential_stiffness_ratio),
        friction_(contact.sliding_friction),
        rolling_friction_(contact.rolling_friction),
        damping_factor_(2.0 * damping_ratio(contact.restitution) * std::sqrt(contact.stiffness)),
        tangential_damping_ratio_(contact.tangential_damping_ratio) {}

  /// ζ of a linear oscillator with restitution e [-].
  static double damping_ratio(double restitution) {
    const double log_e = std::log(restitution);
    return -log_e / std::sqrt(std::numbers::pi * std::numbers::pi + log_e * log_e);
  }

  /// Duration of a collision, π / (ω_0 √(1 − ζ²)) [s].
  static double contact_time(double stiffness, double restitution, double effective_mass) {
    const double zeta = damping_ratio(restitution);
    return std::numbers::pi / std::sqrt(stiffness / effective_mass * (1.0 - zeta * zeta));
  }

  /// Force on i; `spring` is the tangential displacement ξ, carried from step to step.
  ContactForce operator()(const ContactState& contact, double time_step, Vec3& spring) const {
    const double damping = damping_factor_ * contact.root_effective_mass;
    const double approach = dot(contact.relative_velocity, contact.normal);
    const double normal_force = stiffness_ * contact.overlap + damping * approach;

    // The contact plane has turned with the pair since the last step: lay ξ into it, keeping its length.
    const Vec3 slip = contact.relative_velocity - approach * contact.normal;
    const double length_squared = dot(spring, spring);
    Vec3 stretched = spring - dot(spring, contact.normal) * contact.normal;
    const double projected_squared = dot(stretched, stretched);
    if (projected_squared > 0.0) stretched = std::sqrt(length_squared / projected_squared) * stretched;
    stretched = stretched + time_step * slip;

    const double tangential_damping = tangential_damping_ratio_ * damping;
    Vec3 tangential = -tangential_stiffness_ * stretched - tangential_damping * slip;
    const double limit = friction_ * std::max(normal_force, 0.0);
    const double magnitude = norm(tangential);
    if (magnitude > limit) {
      tangential = (limit / magnitude) * tangential;
      stretched = -(1.0 / tangential_stiffness_) * (tangential + tangential_damping * slip);
    }
    spring = stretched;
    return {tangential - normal_force * contact.normal, tangential, normal_force};
  }

  /// Size of the directional constant rolling resistance, Eq. 18: μ_rol r |F_n| [N m], against ω_ij on i and along it
  /// on j.
  ///
  /// Held below what would stop a sphere of inertia `inertia` turning at `speed` within the step: a torque of constant
  /// size has no other way to come to rest.
  [[nodiscard]] double rolling_torque(double normal_force, double radius, double inertia, double speed,
                                      double steps_per_second) const {
    return std::min(rolling_friction_ * radius * std::abs(normal_force), inertia * speed * steps_per_second);
  }
  [[nodiscard]] bool resists_rolling() const { return rolling_friction_ > 0.0; }

 private:
  double stiffness_ = 0.0;
  double tangential_stiffness_ = 0.0;
  double friction_ = 0.0;
  double rolling_friction_ = 0.0;
  double damping_factor_ = 0.0;
  double tangential_damping_ratio_ = 0.0;
};

}  // namespace slfb::dem
