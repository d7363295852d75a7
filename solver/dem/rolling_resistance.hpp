#pragma once

#include <limits>

#include "solver/scene/scene.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::dem {

/// What rolling resistance needs to know of a touching pair; a wall is a body j that has no radius and does not turn.
struct RollingContact {
  double normal_force, normal_stiffness;        ///< [N], [N/m]
  double radius_i, radius_j, effective_radius;  ///< effective: r_i r_j/(r_i + r_j), at a wall r_i [m]
  Vec3 angular_velocity_i, angular_velocity_j;  ///< [rad/s]
  double inverse_inertia_i, inverse_inertia_j;  ///< of the spheres about their centres, 0 for a wall [1/(kg m²)]
  Vec3 normal;                                  ///< from i to j
};

struct RollingTorque {
  Vec3 on_i, on_j;  ///< [N m]
};

struct NoRollingResistance {
  static constexpr bool has_memory = false;
  NoRollingResistance(const Contact&, double /*phase*/) {}
  [[gnu::always_inline]] RollingTorque operator()(const RollingContact&, double /*time_step*/, Vec3& /*memory*/) const {
    return {};
  }
};

/// Directional constant torque (Peng 2014, Eqs. 18 and 19; model A of Ai et al. 2011, Powder Technol. 206:269).
///
/// T_i = −μ_rol r_i |F_n| ω_ij/|ω_ij|, T_j = +μ_rol r_j |F_n| ω_ij/|ω_ij|, ω_ij = (r_i ω_i − r_j ω_j)/(r_i + r_j). With
/// each sphere's own radius, as the paper has it, unequal spheres do not conserve angular momentum; with the reduced
/// radius r_i r_j/(r_i + r_j) for both they do. Held below what would stop the relative rotation within the step:
/// a torque of constant size has no other way to come to rest.
class ConstantRollingTorque {
 public:
  static constexpr bool has_memory = false;
  ConstantRollingTorque(const Contact& contact, double /*phase*/)
      : friction_(contact.rolling_friction), reduced_(contact.rolling_radius == RollingRadius::reduced) {}

  [[gnu::always_inline]] RollingTorque operator()(const RollingContact& c, double time_step, Vec3& /*memory*/) const {
    const double inverse_sum = 1.0 / (c.radius_i + c.radius_j);
    const Vec3 rotation =
        (inverse_sum * c.radius_i) * c.angular_velocity_i - (inverse_sum * c.radius_j) * c.angular_velocity_j;
    const double speed = std::sqrt(dot(rotation, rotation)) + std::numeric_limits<double>::min();
    const double size = friction_ * (c.normal_force < 0.0 ? -c.normal_force : c.normal_force);
    const double stop = speed / time_step;
    const double inverse_inertia = c.inverse_inertia_i + c.inverse_inertia_j;
    const auto torque = [&](double own_radius, double own_inverse_inertia) {
      const double wanted = size * (reduced_ ? c.effective_radius : own_radius);
      const double most =
          stop / (reduced_ ? inverse_inertia : own_inverse_inertia + std::numeric_limits<double>::min());
      return (wanted < most ? wanted : most) / speed;
    };
    return {-torque(c.radius_i, c.inverse_inertia_i) * rotation, torque(c.radius_j, c.inverse_inertia_j) * rotation};
  }

 private:
  double friction_;
  bool reduced_;
};

/// Elastic-plastic spring and dashpot (model C of Ai et al. 2011, Powder Technol. 206:269).
///
/// The relative rolling rotation θ (ω_i − ω_j without its part along the normal) winds a spring of stiffness
/// k_r = 2.25 k_n (μ_rol R_r)², R_r = r_i r_j/(r_i + r_j), up to the torque μ_rol R_r F_n; while it is not fully wound
/// a dashpot C_r = 2 η_r √(I_r k_r), 1/I_r = 1/(I_i + m_i r_i²) + 1/(I_j + m_j r_j²), damps it. Equal and opposite on
/// both spheres. A rolling sphere comes to rest, which no constant torque achieves.
class ElasticPlasticRolling {
 public:
  static constexpr bool has_memory = true;
  /// `phase`: see CoulombFriction.
  ElasticPlasticRolling(const Contact& contact, double phase)
      : friction_(contact.rolling_friction), damping_ratio_(contact.rolling_damping_ratio), phase_(phase) {}

  /// `memory`: the spring's torque on i [N m].
  [[gnu::always_inline]] RollingTorque operator()(const RollingContact& c, double time_step, Vec3& memory) const {
    const double arm = friction_ * c.effective_radius;
    const double stiffness = 2.25 * c.normal_stiffness * arm * arm;
    const Vec3 relative = c.angular_velocity_i - c.angular_velocity_j;
    const Vec3 rolling = relative - dot(relative, c.normal) * c.normal;
    const Vec3 turned = memory - dot(memory, c.normal) * c.normal;
    const Vec3 step = (-time_step * stiffness) * rolling;
    const Vec3 wound = turned + phase_ * step;
    const double limit = arm * (c.normal_force > 0.0 ? c.normal_force : 0.0);
    const double wound_squared = dot(wound, wound);
    const bool slides = wound_squared > limit * limit;
    const double scale = slides ? limit / std::sqrt(wound_squared) : 1.0;
    // I + m r² = 7/2 I for a solid sphere rolling about its contact.
    const double inverse_inertia = (c.inverse_inertia_i + c.inverse_inertia_j) / 3.5;
    const double damping = slides ? 0.0 : 2.0 * damping_ratio_ * std::sqrt(stiffness / inverse_inertia);
    const Vec3 spring = scale * wound;
    const Vec3 ahead = slides ? spring : spring + (1.0 - phase_) * step;
    memory = ahead;
    const Vec3 torque = spring - damping * rolling;
    return {torque, -1.0 * torque};
  }

 private:
  double friction_, damping_ratio_, phase_;
};

}  // namespace slfb::dem
