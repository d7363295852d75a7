// Rolling resistance of the particle engine on planes and inclines.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "correlations/materials.hpp"
#include "tests/verification/few_spheres.hpp"

namespace slfb::dem {
namespace {

constexpr double radius = 0.0025, density = 2230.0;
const double weight = density * Particles::volume_of(radius) * gravitational_acceleration;

Contact rolling_contact(Integrator integrator, RollingModel model, double friction) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.restitution = 0.5;
  contact.sliding_friction = 0.5;
  contact.rolling_friction = friction;
  contact.rolling_model = model;
  contact.integrator = integrator;
  contact.time_step = 1e-5;
  return contact;
}

/// A sphere at rest or rolling along x on the floor, gravity tilted so that it pulls along x by `angle`.
Engine on_incline(const Contact& contact, double angle, double speed, double spin) {
  const double normal = weight * std::cos(angle);
  Engine engine =
      engine_with(contact, {floor_at_zero},
                  {{{0, 0, radius - normal / contact.stiffness}, {speed, 0, 0}, {0, spin, 0}, radius, density}});
  engine.external_force.x[0] = weight * std::sin(angle);
  engine.external_force.z[0] = -normal;
  return engine;
}

// Both models resist a rolling sphere by μ_r r F_n: it slows down by 5/7 μ_r g (Ai et al. 2011, Powder Technol.
// 206:269).
TEST(RollingResistance, SlowsARollingSphere) {
  for (const Integrator integrator : all_integrators)
    for (const RollingModel model : {RollingModel::constant_torque, RollingModel::elastic_plastic}) {
      const double friction = 0.0175, speed = 0.1;
      Engine engine = on_incline(rolling_contact(integrator, model, friction), 0.0, speed, speed / radius);
      // The elastic-plastic spring must be wound first, with a dashpot that acts until then.
      engine.advance(5000);
      const double before = engine.particles.velocity.x[0];
      engine.advance(25000);
      const double lost = 5.0 / 7.0 * friction * gravitational_acceleration * 0.25;
      EXPECT_NEAR(before - engine.particles.velocity.x[0], lost, 1e-3 * lost) << name_of(integrator);
      EXPECT_NEAR(engine.particles.angular_velocity.y[0] * radius, engine.particles.velocity.x[0], 1e-3 * speed);
    }
}

// Without sliding friction nothing but the torque acts: ω = ω_0 − 5/2 μ_r g t/r, and it ends at rest,
// to within what the torque does in a step.
TEST(RollingResistance, SlowsASphereThatOnlySpins) {
  for (const Integrator integrator : all_integrators)
    for (const RollingRadius lever : {RollingRadius::own, RollingRadius::reduced}) {
      const double friction = 0.02, spin = 30.0;
      Contact contact = rolling_contact(integrator, RollingModel::constant_torque, friction);
      contact.sliding_friction = 0.0;
      contact.rolling_radius = lever;
      Engine engine = on_incline(contact, 0.0, 0.0, spin);
      engine.advance(5000);
      const double lost = 2.5 * friction * gravitational_acceleration * 0.05 / radius;
      EXPECT_NEAR(spin - engine.particles.angular_velocity.y[0], lost, 2e-3 * lost) << name_of(integrator);
      EXPECT_NEAR(engine.particles.velocity.x[0], 0.0, 1e-12);
      engine.advance(15000);
      EXPECT_NEAR(engine.particles.angular_velocity.y[0], 0.0, 0.5 * lost / 5000) << name_of(integrator);
    }
}

/// Two unequal spheres pressed together by 0.1 N that turn about parallel axes: rates of change of ω.
struct Spins {
  double first, second, momentum;  ///< momentum: of I_1 ω_1' + I_2 ω_2'
};
Spins spin_rates(const Contact& contact) {
  Engine engine = engine_with(contact, {},
                              {{{0, 0, 0}, {}, {0, 40, 0}, radius, density},
                               {{2.5 * radius - 1e-5, 0, 0}, {}, {0, 10, 0}, 1.5 * radius, 3.0 * density}});
  engine.external_force.x[0] = 0.1;
  engine.external_force.x[1] = -0.1;
  engine.advance(50);
  const double time = 50 * contact.time_step;
  const auto& w = engine.particles.angular_velocity.y;
  const Spins rates{(w[0] - 40.0) / time, (w[1] - 10.0) / time, 0.0};
  return {rates.first, rates.second,
          engine.particles.inertia(0) * rates.first + engine.particles.inertia(1) * rates.second};
}

// Peng (2014), Eqs. 18 and 19: torques μ_r r_i F_n and μ_r r_j F_n, opposite, on each with its own radius or on both
// with r_i r_j/(r_i + r_j). Here r_i ω_i > r_j ω_j.
TEST(RollingResistance, OfUnequalSpheres) {
  for (const Integrator integrator : all_integrators) {
    Contact contact = rolling_contact(integrator, RollingModel::constant_torque, 0.01);
    contact.sliding_friction = 0.0;
    const double first = 0.4 * density * Particles::volume_of(radius) * radius * radius;
    const double second = 0.4 * 3.0 * density * Particles::volume_of(1.5 * radius) * 2.25 * radius * radius;
    const double torque = 0.01 * 0.1 * radius;
    const Spins own = spin_rates(contact);
    EXPECT_NEAR(own.first * first, -torque, 5e-3 * torque) << name_of(integrator);
    EXPECT_NEAR(own.second * second, 1.5 * torque, 5e-3 * torque) << name_of(integrator);
    contact.rolling_radius = RollingRadius::reduced;
    const Spins reduced = spin_rates(contact);
    EXPECT_NEAR(reduced.first * first, -0.6 * torque, 5e-3 * torque) << name_of(integrator);
    EXPECT_NEAR(reduced.momentum, 0.0, 1e-10 * torque) << name_of(integrator);
  }
}

// Ai et al. (2011), model C: a sphere that rolls comes to rest where the spring is wound, rocks on it and stays.
TEST(RollingResistance, ElasticPlasticComesToRest) {
  for (const Integrator integrator : all_integrators) {
    const double friction = 0.05, speed = 0.05;
    const Contact contact = rolling_contact(integrator, RollingModel::elastic_plastic, friction);
    Engine engine = on_incline(contact, 0.0, speed, speed / radius);
    const double stop = speed / (5.0 / 7.0 * friction * gravitational_acceleration);
    // While the spring winds up to M = μ_r R m g, which turns it by M/k_r, the dashpot C_r = 2 η_r √(k_r I_r) takes
    // C_r (M/k_r)/I_r of the spin.
    const double mass = density * Particles::volume_of(radius), arm = friction * radius;
    const double stiffness = 2.25 * contact.stiffness * arm * arm, inertia = 1.4 * mass * radius * radius;
    const double lost = 2.0 * contact.rolling_damping_ratio * arm * mass * gravitational_acceleration /
                        std::sqrt(stiffness * inertia) * radius;
    const double way = 0.5 * (speed - lost) / speed * (speed - lost) * stop;
    engine.advance(std::llround(1.2 * stop / 1e-5));
    const double place = engine.particles.position.x[0];
    EXPECT_NEAR(place, way, 0.01 * way) << name_of(integrator);
    engine.advance(std::llround(stop / 1e-5));
    EXPECT_NEAR(engine.particles.position.x[0], place, 1e-4 * way) << name_of(integrator);
    EXPECT_LT(std::abs(engine.particles.velocity.x[0]), 1e-6 * speed) << name_of(integrator);
    EXPECT_LT(std::abs(engine.particles.angular_velocity.y[0]) * radius, 1e-6 * speed) << name_of(integrator);
  }
}

// On an incline it stays where tan θ < μ_r and above rolls down with 5/7 g (sin θ − μ_r cos θ).
TEST(RollingResistance, OnAnIncline) {
  const double friction = 0.1;
  for (const Integrator integrator : all_integrators) {
    const Contact contact = rolling_contact(integrator, RollingModel::elastic_plastic, friction);
    for (const double slope : {0.05, 0.09}) {
      Engine engine = on_incline(contact, std::atan(slope), 0.0, 0.0);
      engine.advance(30000);
      const double place = engine.particles.position.x[0];
      EXPECT_LT(place, 0.02 * radius) << name_of(integrator);
      engine.advance(20000);
      EXPECT_NEAR(engine.particles.position.x[0], place, 1e-5 * radius) << name_of(integrator) << " " << slope;
      EXPECT_LT(std::abs(engine.particles.velocity.x[0]), 1e-7) << name_of(integrator) << " " << slope;
    }
    for (const double slope : {0.12, 0.3}) {
      const double angle = std::atan(slope);
      const double acceleration =
          5.0 / 7.0 * gravitational_acceleration * (std::sin(angle) - friction * std::cos(angle));
      Engine engine = on_incline(contact, angle, 0.0, 0.0);
      engine.advance(10000);
      const double before = engine.particles.velocity.x[0];
      engine.advance(10000);
      EXPECT_NEAR((engine.particles.velocity.x[0] - before) / 0.1, acceleration, 2e-3 * acceleration)
          << name_of(integrator) << " " << slope;
    }
  }
}

}  // namespace
}  // namespace slfb::dem
