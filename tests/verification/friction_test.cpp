// Friction of the particle engine: slip to roll, oblique impacts that slide, stick and do both, and pairs of spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <vector>

#include "correlations/materials.hpp"
#include "solver/dem/contact_reference.hpp"
#include "solver/dem/hertz_mindlin.hpp"
#include "tests/verification/few_spheres.hpp"

namespace slfb::dem {
namespace {

using std::numbers::pi;

constexpr double radius = 0.0025, density = 4000.0;
const double mass = density * Particles::volume_of(radius);

// DEM04 of MFIX (1 mm, 1e4 kg/m³, 0.1 m/s): a sphere set sliding on a plane rolls after μ g t/u_0 = 2/7, with 5/7 u_0.
TEST(SlipToRoll, EndsAfterTwoSeventhsWithFiveSevenths) {
  const double r = 0.0005, u0 = 0.1;
  for (const Integrator integrator : all_integrators)
    for (const double friction : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      Contact contact;
      contact.stiffness = 1e3;
      contact.restitution = 0.5;
      contact.sliding_friction = friction;
      contact.integrator = integrator;
      contact.time_step = 5e-6;
      const double weight = 1e4 * Particles::volume_of(r) * gravitational_acceleration;
      Engine engine =
          engine_with(contact, {floor_at_zero}, {{{0, 0, r - weight / contact.stiffness}, {u0, 0, 0}, {}, r, 1e4}});
      engine.external_force.z[0] = -weight;
      const double rolling_time = 2.0 / 7.0 * u0 / (friction * gravitational_acceleration);
      const auto& v = engine.particles.velocity.x[0];
      const auto& w = engine.particles.angular_velocity.y[0];
      engine.advance(std::llround(0.5 * rolling_time / contact.time_step));
      // Uniformly accelerated until then.
      EXPECT_NEAR(v, u0 * (1.0 - 1.0 / 7.0), 2e-3 * u0) << name_of(integrator) << ", μ = " << friction;
      EXPECT_NEAR(w * r, 2.5 / 7.0 * u0, 3e-3 * u0) << name_of(integrator) << ", μ = " << friction;
      double slip_ended = 0.0;
      for (int k = 0; k < 2.0 * rolling_time / contact.time_step; ++k) {
        engine.step();
        if (slip_ended == 0.0 && v - w * r < 1e-3 * u0)
          slip_ended = static_cast<double>(engine.steps()) * contact.time_step;
      }
      EXPECT_NEAR(slip_ended, rolling_time, 0.01 * rolling_time) << name_of(integrator) << ", μ = " << friction;
      EXPECT_NEAR(v, 5.0 / 7.0 * u0, 1e-3 * u0) << name_of(integrator) << ", μ = " << friction;
      EXPECT_NEAR(w * r, 5.0 / 7.0 * u0, 2e-3 * u0) << name_of(integrator) << ", μ = " << friction;
    }
}

// --- oblique impacts -------------------------------------------------------------------------------------------------

struct Outcome {
  double velocity_x, velocity_z, spin;
};

/// A sphere strikes the floor with speed (v_x, −v_z) and spin about y.
struct Impact {
  Contact contact;
  double velocity_x, velocity_z, spin = 0.0;

  /// `duration` of the contact, about.
  [[nodiscard]] Outcome by_engine(double duration, int steps, double phase = 0.41) const {
    Contact stepped = contact;
    stepped.time_step = duration / steps;
    const double gap = (3.0 - phase) * stepped.time_step * velocity_z;
    Engine engine = engine_with(stepped, {floor_at_zero},
                                {{{0, 0, radius + gap}, {velocity_x, 0, -velocity_z}, {0, spin, 0}, radius, density}});
    engine.advance(static_cast<std::int64_t>(1.8 * steps) + 5);
    EXPECT_TRUE(engine.touching_pairs().empty());
    return {engine.particles.velocity.x[0], engine.particles.velocity.z[0], engine.particles.angular_velocity.y[0]};
  }
};

// Chung & Ooi (2011), Granular Matter 13:643, test 4: aluminium oxide at 3.9 m/s on a rigid plane, Hertz and Mindlin.
// Sliding all the way v_x' = v_x − μ (1 + e) v_z and ω' = 5/2 μ (1 + e) v_z/r.
TEST(ObliqueImpact, SlidesGrosslyAsOfChungAndOoi) {
  struct Case {
    double degrees, ratio, spin;
  };
  for (const Integrator integrator : all_integrators)
    for (const Case& c : {Case{40.0, 0.7829, 544.2}, Case{60.0, 0.8948, 355.2}}) {
      Contact contact;
      contact.law = "hertz";
      contact.integrator = integrator;
      contact.youngs_modulus = 380e9;
      contact.poisson_ratio = 0.23;
      contact.rigid_walls = true;
      contact.restitution = 0.98;
      contact.sliding_friction = 0.092;
      const double v_x = 3.9 * std::sin(c.degrees * pi / 180.0), v_z = 3.9 * std::cos(c.degrees * pi / 180.0);
      const Outcome outcome = Impact{contact, v_x, v_z}.by_engine(6.5e-6, 1000);
      EXPECT_NEAR(outcome.velocity_z / v_z, 0.98, 5e-4) << name_of(integrator);
      EXPECT_NEAR(outcome.velocity_x / v_x, c.ratio, 1e-4) << name_of(integrator);
      // Friction acts at the wall, nearer to the centre than r by the overlap: on its average 0.86 of the largest.
      const double overlap = 0.86 * 8.089e-6 * std::pow(v_z / 3.9, 0.8);
      EXPECT_NEAR(outcome.spin, c.spin * (1.0 - overlap / radius), 4e-4 * c.spin) << name_of(integrator);
    }
}

/// Elastic normally and without a dashpot along the wall.
Contact elastic(double tangential_stiffness_ratio, double friction) {
  Contact contact;
  contact.stiffness = 1e6;
  contact.restitution = 1.0;
  contact.tangential_stiffness_ratio = tangential_stiffness_ratio;
  contact.tangential_damping_ratio = 0.0;
  contact.sliding_friction = friction;
  return contact;
}

// Spin and oblique speed under the linear law, sliding all the way: k_t v_t > μ k_n v_n at the start.
TEST(ObliqueImpact, SlidesGrosslyWithSpin) {
  for (const Integrator integrator : all_integrators)
    for (const double spin : {0.0, 60.0, -60.0}) {
      Impact impact{elastic(2.0 / 7.0, 0.05), 0.3, 0.1, spin};
      impact.contact.integrator = integrator;
      const Outcome outcome = impact.by_engine(pi * std::sqrt(mass / impact.contact.stiffness), 1000);
      const double change = 0.05 * 2.0 * 0.1;
      EXPECT_NEAR(outcome.velocity_x, 0.3 - change, 2e-3 * change) << name_of(integrator);
      EXPECT_NEAR((outcome.spin - spin) * radius, 2.5 * change, 2e-3 * 2.5 * change) << name_of(integrator);
    }
}

// No limit: m_t dv_t/dt = −k_t ξ, 1/m_t = 1/m + r²/I = 7/(2 m), for half a period π √(m/k_n) of the normal oscillator,
// so that the slip is turned into cos(π √(7/2 k_t/k_n)) of itself. So slow that the overlap is nothing beside r.
TEST(ObliqueImpact, SticksAsAnOscillator) {
  for (const Integrator integrator : all_integrators)
    for (const double ratio : {2.0 / 7.0, 0.8, 1.0}) {
      const double v_x = 5e-5, spin = -0.012, slip = v_x - spin * radius;
      const double cosine = std::cos(pi * std::sqrt(3.5 * ratio));
      std::vector<double> errors;
      for (const int steps : {101, 202, 404, 808}) {
        Impact impact{elastic(ratio, 1e9), v_x, 1e-4, spin};
        impact.contact.integrator = integrator;
        const Outcome o = impact.by_engine(pi * std::sqrt(mass / impact.contact.stiffness), steps);
        errors.push_back(std::abs((o.velocity_x - o.spin * radius) / slip - cosine));
        // The force at the point of contact changes neither.
        EXPECT_NEAR(o.velocity_x + 0.4 * radius * o.spin, v_x + 0.4 * radius * spin, 1e-6 * slip);
      }
      // The velocities of symplectic Euler, and with them the spring, are half a step late.
      const bool euler = integrator == Integrator::symplectic_euler;
      EXPECT_LT(errors.front(), euler ? 2.5e-2 : 2.5e-3) << name_of(integrator) << ", k_t/k_n = " << ratio;
      EXPECT_LT(errors.back(), euler ? 3.2e-3 : 4e-5) << name_of(integrator) << ", k_t/k_n = " << ratio;
    }
}

// All regimes of Maw, Barber & Fawcett (1976) with both dashpots, sticking to sliding, against the reference.
TEST(ObliqueImpact, FollowsTheReferenceAtAllAngles) {
  const double v = 0.01, stiffness = 1e6;
  for (const double e : {1.0, 0.8})
    for (const double degrees : {2.0, 10.0, 25.0, 40.0, 55.0, 70.0, 80.0})
      for (const double spin : {0.0, -2.0, 2.0}) {
        Contact contact;
        contact.stiffness = stiffness;
        contact.restitution = e;
        contact.sliding_friction = 0.3;
        ReferenceImpact exact;
        exact.law.stiffness = stiffness;
        exact.law.tangential_stiffness = contact.tangential_stiffness_ratio * stiffness;
        exact.law.tangential_damping =
            contact.tangential_damping_ratio * 2.0 * damping_ratio(e) * std::sqrt(stiffness * mass);
        exact.law.restitution = e;
        exact.law.friction = 0.3;
        exact.radius = radius;
        exact.mass = mass;
        exact.normal_speed = v * std::cos(degrees * pi / 180.0);
        exact.tangential_velocity = v * std::sin(degrees * pi / 180.0);
        exact.spin = spin;
        const double duration = LinearSpringDashpot::contact_time(stiffness, e, mass);
        const auto last = reference_impact(exact, {2.0 * duration}).samples.back();
        for (const Integrator integrator : all_integrators) {
          Impact impact{contact, exact.tangential_velocity, exact.normal_speed, spin};
          impact.contact.integrator = integrator;
          const Outcome o = impact.by_engine(duration, 400);
          for (const double error :
               {o.velocity_x - last.velocity_x, o.velocity_z - last.velocity_z, (o.spin - last.spin) * radius})
            EXPECT_LT(std::abs(error), 1.5e-3 * v)
                << name_of(integrator) << ", e = " << e << ", " << degrees << "°, spin " << spin;
        }
      }
}

// Two spheres that are each other's image turned by half a turn about the contact meet as each meets a wall of twice
// the stiffness (the idea of Chung & Ooi 2011, test 8). They turn about each other by some δ/r meanwhile.
TEST(ObliqueImpact, PairOfSpheresIsAWallForEach) {
  for (const Integrator integrator : all_integrators)
    for (const double v_x : {0.01, 0.05, 0.2})
      for (const double spin : {0.0, 30.0}) {
        Contact contact;
        contact.integrator = integrator;
        contact.stiffness = 1e8;
        contact.restitution = 0.8;
        contact.sliding_friction = 0.3;
        contact.time_step = LinearSpringDashpot::contact_time(2e8, 0.8, mass) / 200.5;
        const double v_z = 0.1, gap = 2.41 * contact.time_step * v_z;
        Engine pair = engine_with(contact, {},
                                  {{{0, 0, radius + gap}, {v_x, 0, -v_z}, {0, spin, 0}, radius, density},
                                   {{0, 0, -radius - gap}, {-v_x, 0, v_z}, {0, spin, 0}, radius, density}});
        contact.stiffness = 2e8;
        Engine wall = engine_with(contact, {floor_at_zero},
                                  {{{0, 0, radius + gap}, {v_x, 0, -v_z}, {0, spin, 0}, radius, density}});
        for (Engine* engine : {&pair, &wall}) engine->advance(300);
        const Vec3 difference = at(pair.particles.velocity, 0) - at(wall.particles.velocity, 0);
        const double spins = pair.particles.angular_velocity.y[0] - wall.particles.angular_velocity.y[0];
        const double turn = (v_x + spin * radius) * 200.0 * contact.time_step / radius;
        EXPECT_LT(norm(difference) + radius * std::abs(spins), 4.0 * turn * v_z)
            << name_of(integrator) << " " << v_x << " " << spin;
        EXPECT_NEAR(pair.particles.velocity.x[1], -pair.particles.velocity.x[0], 1e-13 * v_z);
      }
}

}  // namespace
}  // namespace slfb::dem
