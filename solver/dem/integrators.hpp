#pragma once

#include <cstddef>

#include "solver/support/vec3.hpp"

/// Time integrators of the particle engine, each with one force evaluation per step. A step is predict(), which takes a
/// sphere to the point where its forces are wanted, the forces, and correct(), which ends at t + Δt. start() takes the
/// contact accelerations of the start. The acceleration `constant` by forces other than contacts does not change over
/// the steps of one call of Engine::advance(); it comes apart, because it may jump between calls.
///
/// An integrator has `spring_phase` (see CoulombFriction) and `memory_size`, the vectors that it keeps per sphere.
namespace slfb::dem {

/// One sphere to an integrator. `memory`: Integrator::memory_size vectors of its own.
struct Body {
  Vec4 &position, &velocity, &angular_velocity;
  Vec4* memory;
};

/// Accelerations of a sphere by its contacts, linear [m/s²] and angular [rad/s²].
struct Acceleration {
  Vec3 linear, angular;
};

/// v' = v + Δt a(x, v), x' = x + Δt v' (first order, symplectic without damping).
struct SymplecticEuler {
  static constexpr double spring_phase = 1.0;
  static constexpr std::size_t memory_size = 0;
  static void start(Body, Acceleration) {}
  static void predict(Body, Vec3 /*constant*/, double /*step*/) {}
  static void correct(Body b, Acceleration contact, Vec3 constant, double step) {
    b.velocity.add(step * (contact.linear + constant));
    b.angular_velocity.add(step * contact.angular);
    b.position.add(step * b.velocity.vector());
  }
};

/// Kick, drift, kick (Swope et al. 1982); forces that depend on the velocity see it predicted with the last
/// acceleration. Second order.
struct VelocityVerlet {
  static constexpr double spring_phase = 0.5;
  static constexpr std::size_t memory_size =
      4;  ///< contact accelerations of the last step, linear and angular; half-step v, ω
  static void start(Body b, Acceleration contact) {
    b.memory[0].set(contact.linear);
    b.memory[1].set(contact.angular);
  }
  static void predict(Body b, Vec3 constant, double step) {
    const Vec3 a = b.memory[0].vector() + constant, alpha = b.memory[1].vector();
    const Vec3 v = b.velocity.vector(), w = b.angular_velocity.vector();
    const Vec3 half = v + (0.5 * step) * a;
    b.memory[2].set(half);
    b.memory[3].set(w + (0.5 * step) * alpha);
    b.position.add(step * half);
    b.velocity.set(v + step * a);
    b.angular_velocity.set(w + step * alpha);
  }
  static void correct(Body b, Acceleration contact, Vec3 constant, double step) {
    b.memory[0].set(contact.linear);
    b.memory[1].set(contact.angular);
    b.velocity.set(b.memory[2].vector() + (0.5 * step) * (contact.linear + constant));
    b.angular_velocity.set(b.memory[3].vector() + (0.5 * step) * contact.angular);
  }
};

/// Drift, kick, drift (leapfrog); forces that depend on the velocity see it predicted at the half step. Second order.
struct PositionVerlet {
  static constexpr double spring_phase = 0.5;
  static constexpr std::size_t memory_size = 4;  ///< contact accelerations of the last step, linear and angular; v, ω
  static void start(Body b, Acceleration contact) {
    b.memory[0].set(contact.linear);
    b.memory[1].set(contact.angular);
  }
  static void predict(Body b, Vec3 constant, double step) {
    b.memory[2].set(b.velocity.vector());
    b.memory[3].set(b.angular_velocity.vector());
    b.position.add((0.5 * step) * b.velocity.vector());
    b.velocity.add((0.5 * step) * (b.memory[0].vector() + constant));
    b.angular_velocity.add((0.5 * step) * b.memory[1].vector());
  }
  static void correct(Body b, Acceleration contact, Vec3 constant, double step) {
    b.memory[0].set(contact.linear);
    b.memory[1].set(contact.angular);
    b.velocity.set(b.memory[2].vector() + step * (contact.linear + constant));
    b.angular_velocity.set(b.memory[3].vector() + step * contact.angular);
    b.position.add((0.5 * step) * b.velocity.vector());
  }
};

/// Gear's predictor-corrector (Gear 1971; Allen & Tildesley 1987, App. E): five values of the position with the
/// coefficients for forces that depend on the velocity (19/90, 3/4, 1, 1/2, 1/12), four of the angular_velocity (3/8,
/// 1, 3/4, 1/6). Of fourth order where the force is smooth, which it is not where a contact begins or ends.
struct Gear {
  static constexpr double spring_phase = 0.5;
  static constexpr std::size_t memory_size = 6;  ///< contact acceleration and its two derivatives, linear, then angular
  static void start(Body b, Acceleration contact) {
    b.memory[0].set(contact.linear);
    b.memory[3].set(contact.angular);
  }
  static void predict(Body b, Vec3 constant, double step) {
    const double h = step, h2 = h * h / 2.0, h3 = h * h2 / 3.0, h4 = h * h3 / 4.0;
    const Vec3 a = b.memory[0].vector(), jerk = b.memory[1].vector(), snap = b.memory[2].vector();
    b.position.add(h * b.velocity.vector() + h2 * (a + constant) + h3 * jerk + h4 * snap);
    b.velocity.add(h * (a + constant) + h2 * jerk + h3 * snap);
    b.memory[0].add(h * jerk + h2 * snap);
    b.memory[1].add(h * snap);
    const Vec3 alpha = b.memory[3].vector(), first = b.memory[4].vector(), second = b.memory[5].vector();
    b.angular_velocity.add(h * alpha + h2 * first + h3 * second);
    b.memory[3].add(h * first + h2 * second);
    b.memory[4].add(h * second);
  }
  static void correct(Body b, Acceleration contact, Vec3 /*constant*/, double step) {
    const double h = step;
    const Vec3 error = contact.linear - b.memory[0].vector();
    b.position.add((19.0 / 90.0 * h * h / 2.0) * error);
    b.velocity.add((3.0 / 4.0 * h / 2.0) * error);
    b.memory[0].set(contact.linear);
    b.memory[1].add((1.0 / 2.0 * 3.0 / h) * error);
    b.memory[2].add((1.0 / 12.0 * 12.0 / (h * h)) * error);
    const Vec3 angular_error = contact.angular - b.memory[3].vector();
    b.angular_velocity.add((3.0 / 8.0 * h) * angular_error);
    b.memory[3].set(contact.angular);
    b.memory[4].add((3.0 / 4.0 * 2.0 / h) * angular_error);
    b.memory[5].add((1.0 / 6.0 * 6.0 / (h * h)) * angular_error);
  }
};

}  // namespace slfb::dem
