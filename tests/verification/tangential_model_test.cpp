// The spring and the dashpot along the contact plane, each alone: exact solutions of the linear law.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "correlations/materials.hpp"
#include "solver/dem/linear_spring_dashpot.hpp"
#include "tests/verification/few_spheres.hpp"

namespace slfb::dem {
namespace {

constexpr double radius = 0.0025, density = 2230.0, stiffness = 1e7, speed = 0.5, slip = 0.2;
const double mass = density * Particles::volume_of(radius);

Contact contact_of(TangentialModel model, double restitution, double friction, Integrator integrator) {
  Contact contact;
  contact.tangential_model = model;
  contact.stiffness = stiffness;
  contact.restitution = restitution;
  contact.sliding_friction = friction;
  contact.integrator = integrator;
  contact.time_step = LinearSpringDashpot::contact_time(stiffness, restitution, mass) / 2000.0;
  return contact;
}

/// Slip after an impact on the floor at `speed` with `slip` before it [m/s].
double slip_after(const Contact& contact) {
  Engine engine = engine_with(contact, {floor_at_zero}, {{{0, 0, radius}, {slip, 0, -speed}, {}, radius, density}});
  engine.advance(2500);
  EXPECT_TRUE(engine.touching_pairs().empty());
  return engine.particles.velocity.x[0] - radius * engine.particles.angular_velocity.y[0];
}

/// How long the normal force pushes [s]: up to the angle where spring and dashpot balance (Schwager & Pöschel 2007).
double push_time(double restitution) {
  const double zeta = damping_ratio(restitution), root = std::sqrt(1.0 - zeta * zeta);
  const double angle = std::numbers::pi - std::atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta);
  return angle / (root * std::sqrt(stiffness / mass));
}

// With so much friction nothing slides: d slip/dt = −7/2 c_t/m slip while the normal force pushes.
TEST(TangentialModel, ADashpotLetsTheSlipDecay) {
  for (const Integrator integrator : all_integrators)
    for (const double ratio : {0.5, 2.0, 5.0}) {
      constexpr double restitution = 0.9;
      Contact contact = contact_of(TangentialModel::dashpot, restitution, 1e9, integrator);
      contact.tangential_damping_ratio = ratio;
      const double damping = ratio * 2.0 * damping_ratio(restitution) * std::sqrt(stiffness * mass);
      const double expected = slip * std::exp(-3.5 * damping / mass * push_time(restitution));
      EXPECT_NEAR(slip_after(contact), expected, 3e-3 * slip) << name_of(integrator) << ", " << ratio;
    }
}

// A dashpot that is always above the limit: friction takes 7/2 μ of the normal impulse off the slip.
TEST(TangentialModel, FrictionLimitsADashpot) {
  for (const Integrator integrator : all_integrators) {
    constexpr double restitution = 0.9, friction = 0.02;
    Contact contact = contact_of(TangentialModel::dashpot, restitution, friction, integrator);
    contact.tangential_damping_ratio = 1e4;
    const double push = speed * (1.0 + LinearSpringDashpot::restitution_without_tension(restitution));
    EXPECT_NEAR(slip_after(contact), slip - 3.5 * friction * push, 3e-3 * slip) << name_of(integrator);
  }
}

// A dashpot remembers nothing: a sphere that a force f pushes along the floor, and that rolls, slips for ever at
// 2/7 f/c_t. A spring holds it.
TEST(TangentialModel, OnlyASpringHolds) {
  for (const TangentialModel model : {TangentialModel::dashpot, TangentialModel::spring_dashpot}) {
    Contact contact = contact_of(model, 0.5, 0.5, Integrator::symplectic_euler);
    contact.stiffness = 1e4;
    contact.time_step = 1e-6;
    const double weight = mass * gravitational_acceleration, push = 0.1 * weight;
    Engine engine = engine_with(contact, {floor_at_zero}, {{{0, 0, radius - weight / 1e4}, {}, {}, radius, density}});
    engine.external_force.z[0] = -weight;
    engine.external_force.x[0] = push;
    engine.advance(100000);
    const double damping = contact.tangential_damping_ratio * 2.0 * damping_ratio(0.5) * std::sqrt(1e4 * mass);
    const double creep = 2.0 / 7.0 * push / damping;
    const double arm = engine.particles.position.z[0];
    const double found = engine.particles.velocity.x[0] - arm * engine.particles.angular_velocity.y[0];
    EXPECT_NEAR(found, model == TangentialModel::dashpot ? creep : 0.0, 1e-3 * creep);
  }
}

// A spring alone: slip and spring swing as cos and sin of √(7/2 k_t/m) t, whatever the normal dashpot takes.
TEST(TangentialModel, ASpringKeepsItsEnergy) {
  for (const Integrator integrator : all_integrators)
    for (const double ratio : {0.1, 2.0 / 7.0, 0.8}) {
      constexpr double restitution = 0.6;
      Contact contact = contact_of(TangentialModel::spring, restitution, 1e9, integrator);
      contact.tangential_stiffness_ratio = ratio;
      const double frequency = std::sqrt(3.5 * ratio * stiffness / mass);
      const double expected = slip * std::cos(frequency * push_time(restitution));
      EXPECT_NEAR(slip_after(contact), expected, 5e-3 * slip) << name_of(integrator) << ", " << ratio;
      // The dashpot of the full model would show.
      contact.tangential_model = TangentialModel::spring_dashpot;
      EXPECT_GT(std::abs(slip_after(contact) - expected), 6e-3 * slip);
    }
}

}  // namespace
}  // namespace slfb::dem
