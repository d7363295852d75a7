// The contact law and the particle engine against exact solutions of one and two bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/dem/engine.hpp"

namespace slfb::dem {
namespace {

constexpr double radius = 0.0025, density = 2230.0;

Contact glass(double restitution, int steps_per_contact, double friction = 0.0) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.restitution = restitution;
  contact.sliding_friction = friction;
  const double effective_mass = 0.5 * density * Particles::volume_of(radius);
  contact.time_step =
      LinearSpringDashpot::contact_time(contact.stiffness, restitution, effective_mass) / steps_per_contact;
  return contact;
}

Engine two_spheres(const Contact& contact, const Vec3& direction, double speed) {
  Engine engine(contact, {}, {0, 0, 0}, 1);
  const double gap = 1.0001 * radius;
  for (double side : {-1.0, 1.0}) {
    const std::size_t i = engine.add_particle(
        {side * gap * direction.x, side * gap * direction.y, side * gap * direction.z}, radius, density, 0);
    engine.particles.velocity.x[i] = -side * 0.5 * speed * direction.x;
    engine.particles.velocity.y[i] = -side * 0.5 * speed * direction.y;
    engine.particles.velocity.z[i] = -side * 0.5 * speed * direction.z;
  }
  return engine;
}

double approach_speed(const Engine& engine, const Vec3& direction) {
  const auto& v = engine.particles.velocity;
  return (v.x[0] - v.x[1]) * direction.x + (v.y[0] - v.y[1]) * direction.y + (v.z[0] - v.z[1]) * direction.z;
}

// Restitution out equals restitution in, along each axis and obliquely; the error falls with the step.
TEST(LinearContact, ReturnsItsRestitution) {
  for (const Vec3 direction :
       {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0.6, 0.0, 0.8}, Vec3{2.0 / 3, -1.0 / 3, 2.0 / 3}})
    for (double restitution : {0.5, 0.7, 0.9, 1.0}) {
      double error[2];
      for (int level : {0, 1}) {
        Engine engine = two_spheres(glass(restitution, level == 0 ? 100 : 400), direction, 0.1);
        const double before = approach_speed(engine, direction);
        for (int k = 0; k < 2000; ++k) engine.step();
        error[level] = std::abs(-approach_speed(engine, direction) / before - restitution);
      }
      EXPECT_LT(error[0], 0.02) << restitution;
      EXPECT_LT(error[1], 0.4 * error[0] + 1e-3) << restitution;
    }
}

// A damped oscillator touches for π/(ω_0 √(1 − ζ²)); the overlap peaks at v/ω_0 for e = 1.
TEST(LinearContact, LastsHalfAPeriodAndPenetratesAsAnOscillator) {
  const Contact contact = glass(1.0, 500);
  Engine engine = two_spheres(contact, {1, 0, 0}, 0.1);
  int touching = 0;
  double deepest = 0.0;
  for (int k = 0; k < 2000; ++k) {
    engine.step();
    if (engine.contacts(0) == 0) continue;
    ++touching;
    deepest = std::max(deepest, engine.maximum_overlap() * radius);
  }
  const double effective_mass = 0.5 * density * Particles::volume_of(radius);
  EXPECT_NEAR(touching, 500, 2);
  EXPECT_NEAR(deepest, 0.1 * std::sqrt(effective_mass / contact.stiffness), 2e-3 * deepest);
}

// Peng (2014), Table 1: 2.69e-4 s for 5 mm glass pairs at 1e4 N/m, 1.25e-4 s for 3 mm, so 5.4 and 2.5 steps of 5e-5 s.
TEST(LinearContact, PaperHasFiveStepsPerContact) {
  const auto contact_time = [](double diameter) {
    return LinearSpringDashpot::contact_time(1e4, 0.9, 0.5 * density * Particles::volume_of(0.5 * diameter));
  };
  EXPECT_NEAR(contact_time(0.005), 2.69e-4, 0.005e-4);
  EXPECT_NEAR(contact_time(0.003), 1.25e-4, 0.005e-4);
}

TEST(LinearContact, ConservesLinearAndAngularMomentum) {
  Contact contact = glass(0.8, 50, 0.3);
  Engine engine = two_spheres(contact, {0.6, 0.0, 0.8}, 0.1);
  engine.particles.velocity.y[0] = 0.05;
  engine.particles.angular_velocity.x[1] = 30.0;
  engine.particles.angular_velocity.z[0] = -10.0;
  const auto momentum = [&] {
    std::array<double, 6> sum{};
    const auto& p = engine.particles;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3 x{p.position.x[i], p.position.y[i], p.position.z[i]};
      const Vec3 v{p.velocity.x[i], p.velocity.y[i], p.velocity.z[i]};
      const Vec3 w{p.angular_velocity.x[i], p.angular_velocity.y[i], p.angular_velocity.z[i]};
      const Vec3 orbital = cross(x, v);
      const double m = p.mass[i], inertia = p.inertia(i);
      const double terms[6] = {m * v.x,
                               m * v.y,
                               m * v.z,
                               m * orbital.x + inertia * w.x,
                               m * orbital.y + inertia * w.y,
                               m * orbital.z + inertia * w.z};
      for (std::size_t k = 0; k < 6; ++k) sum[k] += terms[k];
    }
    return sum;
  };
  const auto before = momentum();
  for (int k = 0; k < 500; ++k) engine.step();
  const auto after = momentum();
  ASSERT_EQ(engine.contact_events(0), 1);
  const double scale = engine.particles.mass[0] * 0.1;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-13 * scale);
  for (std::size_t k = 3; k < 6; ++k) EXPECT_NEAR(after[k], before[k], 1e-13 * scale * radius) << k;
}

// A sphere set sliding on a plane rolls without slip after μ g t/u_0 = 2/7, then at 5/7 of its speed.
TEST(Friction, SlidingSphereRollsAtFiveSevenths) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.restitution = 0.5;
  contact.sliding_friction = 0.3;
  contact.time_step = 1e-5;
  Engine engine(contact, {{Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
  const double mass = density * Particles::volume_of(radius);
  const std::size_t i = engine.add_particle({0, 0, radius - mass * gravity / contact.stiffness}, radius, density, 0);
  engine.external_force.z[i] = -mass * gravity;
  const double u0 = 0.1;
  engine.particles.velocity.x[i] = u0;
  const double rolling_time = 2.0 / 7.0 * u0 / (contact.sliding_friction * gravity);
  double slip_ended = 0.0;
  for (int k = 0; k < 3 * rolling_time / contact.time_step; ++k) {
    engine.step();
    const double slip = engine.particles.velocity.x[i] - engine.particles.angular_velocity.y[i] * radius;
    if (slip_ended == 0.0 && slip < 1e-3 * u0) slip_ended = k * contact.time_step;
  }
  EXPECT_NEAR(slip_ended, rolling_time, 0.01 * rolling_time);
  EXPECT_NEAR(engine.particles.velocity.x[i], 5.0 / 7.0 * u0, 1e-3 * u0);
  EXPECT_NEAR(engine.particles.angular_velocity.y[i] * radius, 5.0 / 7.0 * u0, 2e-3 * u0);
}

// With directional rolling resistance (Eq. 18) a rolling sphere slows down by 5/7 μ_r g.
TEST(RollingResistance, SlowsARollingSphere) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.restitution = 0.5;
  contact.sliding_friction = 0.3;
  contact.rolling_friction = 0.0175;
  contact.time_step = 1e-5;
  Engine engine(contact, {{Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
  const double mass = density * Particles::volume_of(radius);
  const std::size_t i = engine.add_particle({0, 0, radius - mass * gravity / contact.stiffness}, radius, density, 0);
  engine.external_force.z[i] = -mass * gravity;
  engine.particles.velocity.x[i] = 0.1;
  engine.particles.angular_velocity.y[i] = 0.1 / radius;
  const int steps = 20000;
  for (int k = 0; k < steps; ++k) engine.step();
  const double expected = 0.1 - 5.0 / 7.0 * contact.rolling_friction * gravity * steps * contact.time_step;
  EXPECT_NEAR(engine.particles.velocity.x[i], expected, 0.01 * (0.1 - expected));
}

// Gross sliding at a wall: v_x' = v_x − μ (1 + e) v_z and ω = 5/2 μ (1 + e) v_z / r.
TEST(Friction, ObliqueImpactInGrossSliding) {
  Contact contact = glass(0.9, 400, 0.1);
  Engine engine(contact, {{Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
  const std::size_t i = engine.add_particle({0, 0, 1.001 * radius}, radius, density, 0);
  const double vz = 0.1, vx = 0.2;
  engine.particles.velocity.z[i] = -vz;
  engine.particles.velocity.x[i] = vx;
  for (int k = 0; k < 3000; ++k) engine.step();
  EXPECT_NEAR(engine.particles.velocity.z[i], 0.9 * vz, 5e-3 * vz);
  EXPECT_NEAR(engine.particles.velocity.x[i], vx - 0.1 * 1.9 * vz, 5e-3 * vz);
  EXPECT_NEAR(engine.particles.angular_velocity.y[i] * radius, 2.5 * 0.1 * 1.9 * vz, 1e-2 * vz);
}

// In a wide cylinder the wall is a plane.
TEST(CylinderWall, ActsAsAPlaneWhenWide) {
  const Contact contact = glass(0.9, 200, 0.2);
  const double wide = 50.0;
  Engine plane(contact, {{Wall::Kind::plane, 0, -1.0, wide}}, {0, 0, 0}, 1);
  Engine cylinder(contact, {{Wall::Kind::cylinder, 0, 1.0, wide}}, {0, 0, 0}, 1);
  for (Engine* engine : {&plane, &cylinder}) {
    engine->add_particle({wide - 1.001 * radius, 0, 0}, radius, density, 0);
    engine->particles.velocity.x[0] = 0.1;
    engine->particles.velocity.z[0] = 0.05;
    for (int k = 0; k < 1000; ++k) engine->step();
  }
  EXPECT_NEAR(cylinder.particles.velocity.x[0], plane.particles.velocity.x[0], 1e-6);
  EXPECT_NEAR(cylinder.particles.velocity.z[0], plane.particles.velocity.z[0], 1e-6);
  EXPECT_NEAR(cylinder.particles.angular_velocity.y[0], plane.particles.angular_velocity.y[0], 1e-3);
}

TEST(Engine, StopsWhenASphereLeavesThroughAWall) {
  Contact contact = glass(0.9, 20);
  Engine engine(contact, {{Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
  engine.add_particle({0, 0, 1.01 * radius}, radius, density, 0);
  engine.particles.velocity.z[0] = -500.0;
  EXPECT_THROW(for (int k = 0; k < 100; ++k) engine.step(), EngineError);
}

TEST(Engine, StopsAtANumberThatIsNotFinite) {
  Engine engine(glass(0.9, 20), {}, {0, 0, 0}, 1);
  engine.add_particle({0, 0, 0}, radius, density, 0);
  engine.external_force.x[0] = std::nan("");
  EXPECT_THROW(engine.step(), EngineError);
}

// A periodic box sees a collision through its faces as it sees one in its middle.
TEST(Engine, CollidesAcrossPeriodicFaces) {
  const Contact contact = glass(0.9, 100);
  Engine inside(contact, {}, {0.05, 0.05, 0.05}, 1), across(contact, {}, {0.05, 0.05, 0.05}, 1);
  for (auto [engine, shift] : {std::pair{&inside, 0.0}, std::pair{&across, 0.025}}) {
    for (double side : {-1.0, 1.0}) {
      double x = side * 1.001 * radius + shift;
      if (x > 0.025) x -= 0.05;
      const std::size_t i = engine->add_particle({x, 0, 0}, radius, density, 0);
      engine->particles.velocity.x[i] = -side * 0.05;
    }
    for (int k = 0; k < 1000; ++k) engine->step();
  }
  EXPECT_NEAR(across.particles.velocity.x[0], inside.particles.velocity.x[0], 1e-9);
  EXPECT_EQ(across.contact_events(0), 1);
}

}  // namespace
}  // namespace slfb::dem
