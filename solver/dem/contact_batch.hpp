#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "solver/dem/coulomb_friction.hpp"
#include "solver/dem/rolling_resistance.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::dem {

/// Some touching pairs, one array per quantity: filled from four Vec4 at a time, computed as many at once as a vector
/// register holds, and read back as Vec4. Small enough for the first cache.
struct ContactBatch {
  static constexpr std::size_t capacity = 96;
  using Scalars = std::array<double, capacity>;

  /// Four scalars per contact, usually a vector and what comes with it.
  struct alignas(64) Vectors {
    Scalars x, y, z, w;
    [[nodiscard]] Vec3 at(std::size_t k) const { return {x[k], y[k], z[k]}; }
    void set(std::size_t k, Vec3 v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }

    /// Contacts k to k + 3, in and out; k is a multiple of four.
    void put(std::size_t k, Pack a, Pack b, Pack c, Pack d) {
      transpose(a, b, c, d);
      store(&x[k], a);
      store(&y[k], b);
      store(&z[k], c);
      store(&w[k], d);
    }
    void get(std::size_t k, std::array<Pack, 4>& contacts) const {
      contacts = {load(&x[k]), load(&y[k]), load(&z[k]), load(&w[k])};
      transpose(contacts[0], contacts[1], contacts[2], contacts[3]);
    }
  };

  // Input; j is the second sphere, or the nearest point of a wall: a sphere at rest without radius.
  Vectors position_i, position_j;                  ///< centre [m]
  Vectors relative_velocity;                       ///< v_i − v_j of the centres [m/s]
  Vectors angular_velocity_i, angular_velocity_j;  ///< [rad/s]
  // Carried from step to step.
  Vectors spring;          ///< tangential [m]
  Vectors rolling_memory;  ///< [N m]
  // Output.
  Vectors force;               ///< on i [N]
  Vectors torque_i, torque_j;  ///< [N m]

  // The fourth numbers of these vectors.
  double& radius_i(std::size_t k) { return position_i.w[k]; }                   ///< [m]
  double& radius_j(std::size_t k) { return position_j.w[k]; }                   ///< [m]
  double& inverse_inertia_i(std::size_t k) { return angular_velocity_i.w[k]; }  ///< [1/(kg m²)]
  double& inverse_inertia_j(std::size_t k) { return angular_velocity_j.w[k]; }  ///< 0 of a wall [1/(kg m²)]
  double& root_effective_mass(std::size_t k) { return spring.w[k]; }            ///< √m_eff [kg^½]
  double& normal_force(std::size_t k) { return force.w[k]; }                    ///< compressive positive [N]
  double& overlap(std::size_t k) { return torque_i.w[k]; }                      ///< [m]
  double& approach_speed(std::size_t k) { return torque_j.w[k]; }               ///< along the normal [m/s]
};

/// Forces and torques of the first `count` contacts, a multiple of four. `AtWall`: j is a wall.
///
/// The contact plane halves the overlap of two spheres; at a wall it is the wall. So the lever arms of a pair add up to
/// the distance of the centres, which conserves angular momentum.
template <bool AtWall, class Law, class Friction, class Rolling>
void compute_contacts(ContactBatch& b, std::size_t count, const Law& law, const Friction& friction,
                      const Rolling& rolling, double time_step) {
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 d = b.position_j.at(k) - b.position_i.at(k);
    const double ri = b.radius_i(k), rj = b.radius_j(k);
    const double distance = std::sqrt(dot(d, d));
    const Vec3 normal = (1.0 / distance) * d;
    const double overlap = ri + rj - distance;
    const double arm_i = AtWall ? distance : ri - 0.5 * overlap, arm_j = AtWall ? 0.0 : rj - 0.5 * overlap;
    const Vec3 angular_velocity_i = b.angular_velocity_i.at(k), angular_velocity_j = b.angular_velocity_j.at(k);
    const Vec3 velocity =
        b.relative_velocity.at(k) + cross(arm_i * angular_velocity_i + arm_j * angular_velocity_j, normal);
    const double approach = dot(velocity, normal);
    const double effective_radius = AtWall ? ri : ri * rj / (ri + rj);
    const NormalContact contact = law(overlap, approach, b.root_effective_mass(k), effective_radius);
    Vec3 spring = b.spring.at(k);
    const Vec3 tangential = friction(contact, normal, velocity - approach * normal, time_step, spring);
    b.spring.set(k, spring);
    const Vec3 lever = cross(normal, tangential);
    Vec3 torque_i = arm_i * lever, torque_j = arm_j * lever;
    if constexpr (!std::is_same_v<Rolling, NoRollingResistance>) {
      const RollingContact rolling_contact{contact.force,
                                           contact.stiffness,
                                           ri,
                                           rj,
                                           effective_radius,
                                           angular_velocity_i,
                                           angular_velocity_j,
                                           b.inverse_inertia_i(k),
                                           b.inverse_inertia_j(k),
                                           normal};
      Vec3 memory = b.rolling_memory.at(k);
      const RollingTorque torque = rolling(rolling_contact, time_step, memory);
      if constexpr (Rolling::has_memory) b.rolling_memory.set(k, memory);
      torque_i = torque_i + torque.on_i;
      torque_j = torque_j + torque.on_j;
    }
    b.torque_i.set(k, torque_i);
    b.torque_j.set(k, torque_j);
    b.force.set(k, tangential - contact.force * normal);
    b.normal_force(k) = contact.force;
    b.overlap(k) = overlap;
    b.approach_speed(k) = approach;
  }
}

}  // namespace slfb::dem
