// Walls with properties of their own: bounce, sliding, rolling and rest go by them, contacts of spheres do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "correlations/materials.hpp"
#include "tests/verification/few_spheres.hpp"

namespace slfb::dem {
namespace {

constexpr double radius = 0.0025, density = 2230.0;
const double mass = density * Particles::volume_of(radius);

Contact contact_of(const std::string& law) {
  Contact contact;
  contact.law = law;
  contact.stiffness = 1e5;
  contact.youngs_modulus = 1e8;
  contact.time_step = 1e-7;
  return contact;
}

/// Speed after over speed before, of a sphere that strikes the floor at 0.5 m/s.
double bounce(const Contact& contact) {
  Engine engine = engine_with(contact, {floor_at_zero}, {{{0, 0, radius}, {0, 0, -0.5}, {}, radius, density}});
  while (engine.particles.velocity.z[0] < 0.0 || engine.touches_wall(0, 0)) engine.step();
  return engine.particles.velocity.z[0] / 0.5;
}

/// The same of the relative speed of two spheres.
double bounce_of_two(const Contact& contact) {
  Engine engine = engine_with(contact, {floor_at_zero},
                              {{{0, 0, 1.0}, {0, 0, 0.25}, {}, radius, density},
                               {{0, 0, 1.0 + 2.0 * radius}, {0, 0, -0.25}, {}, radius, density}});
  const auto& z = engine.particles.position.z;
  const auto& v = engine.particles.velocity.z;
  while (v[1] < v[0] || z[1] - z[0] < 2.0 * radius) engine.step();
  return (v[1] - v[0]) / 0.5;
}

TEST(WallContact, BouncesWithTheRestitutionOfTheWall) {
  for (const std::string law : {"linear", "hertz"})
    for (const double e : {0.3, 0.6, 0.95}) {
      Contact contact = contact_of(law);
      contact.restitution = 0.8;
      contact.wall.restitution = e;
      EXPECT_NEAR(bounce(contact), e, 1e-3) << law;
      EXPECT_NEAR(bounce_of_two(contact), 0.8, 1e-3) << law;
    }
}

/// On the floor, where its weight has pressed it in, with the velocity `speed` along x.
Engine on_the_floor(const Contact& contact, double speed, double spin) {
  const double overlap = mass * gravitational_acceleration / contact.at_wall().stiffness;
  Engine engine =
      engine_with(contact, {floor_at_zero}, {{{0, 0, radius - overlap}, {speed, 0, 0}, {0, spin, 0}, radius, density}});
  engine.external_force.z[0] = -mass * gravitational_acceleration;
  return engine;
}

// Before it rolls a sphere loses μ g t.
TEST(WallContact, SlidesWithTheFrictionOfTheWall) {
  for (const double friction : {0.0, 0.1, 0.5}) {
    Contact contact = contact_of("linear");
    contact.time_step = 1e-6;
    contact.sliding_friction = 0.3;
    contact.wall.sliding_friction = friction;
    Engine engine = on_the_floor(contact, 1.0, 0.0);
    engine.advance(20000);
    const double loss = friction * gravitational_acceleration * 0.02;
    EXPECT_NEAR(1.0 - engine.particles.velocity.x[0], loss, 1e-3 * loss + 1e-12) << friction;
  }
}

// Ai et al. (2011), model A: a rolling sphere is slowed by 5/7 μ_rol g.
TEST(WallContact, RollsWithTheRollingFrictionOfTheWall) {
  for (const double rolling : {0.0, 0.02, 0.1}) {
    Contact contact = contact_of("linear");
    contact.time_step = 1e-6;
    contact.sliding_friction = 0.5;
    contact.rolling_friction = 0.05;
    contact.wall.rolling_friction = rolling;
    Engine engine = on_the_floor(contact, 1.0, 1.0 / radius);
    engine.advance(100000);
    const double loss = 5.0 / 7.0 * rolling * gravitational_acceleration * 0.1;
    EXPECT_NEAR(1.0 - engine.particles.velocity.x[0], loss, 5e-3 * loss + 1e-4) << rolling;
  }
}

TEST(WallContact, RestsAtTheOverlapOfItsWeight) {
  Contact contact = contact_of("linear");
  contact.wall.stiffness = 2e3;
  contact.wall.restitution = 0.2;
  contact.integrator = Integrator::velocity_verlet;
  contact.time_step = 1e-5;
  Engine engine = engine_with(contact, {floor_at_zero}, {{{0, 0, radius}, {}, {}, radius, density}});
  engine.external_force.z[0] = -mass * gravitational_acceleration;
  engine.advance(50000);
  EXPECT_NEAR(radius - engine.particles.position.z[0], mass * gravitational_acceleration / 2e3, 1e-12);
  EXPECT_NEAR(engine.network_frequency_squared(), 2.0 * 2e3 / mass, 1e-9 * 2e3 / mass);
}

/// Largest overlap of a sphere that strikes the floor.
double deepest(const Contact& contact) {
  Engine engine = engine_with(contact, {floor_at_zero}, {{{0, 0, radius}, {0, 0, -0.5}, {}, radius, density}});
  while (engine.particles.velocity.z[0] < 0.0) engine.step();
  return radius - engine.particles.position.z[0];
}

// Hertz: δ_max = (15 m v²/(16 √R E*))^{2/5}, 1/E* = Σ (1 − ν²)/E of both bodies.
TEST(WallContact, DeformsAsBothMaterialsDo) {
  Contact contact = contact_of("hertz");
  contact.restitution = 1.0;
  contact.poisson_ratio = 0.25;
  contact.wall.youngs_modulus = 3e7;
  contact.wall.poisson_ratio = 0.4;
  const double modulus = 1.0 / ((1.0 - 0.0625) / 1e8 + (1.0 - 0.16) / 3e7);
  const double expected = std::pow(15.0 * mass * 0.25 / (16.0 * std::sqrt(radius) * modulus), 0.4);
  EXPECT_NEAR(deepest(contact), expected, 1e-4 * expected);
}

TEST(WallContact, AStiffMaterialIsARigidWall) {
  Contact stiff = contact_of("hertz"), rigid = stiff;
  stiff.wall.youngs_modulus = 1e18;
  rigid.rigid_walls = true;
  EXPECT_NEAR(deepest(stiff), deepest(rigid), 1e-9 * radius);
  EXPECT_LT(deepest(rigid), 0.9 * deepest(contact_of("hertz")));
}

// A tube hardly wider than the sphere: between its walls an elastic sphere without friction keeps its energy, and
// presses itself in by v √(m/k) at most. Steps as long as these make the skin of the neighbour list wider than the gap.
TEST(WallContact, ANarrowTubeHoldsItsSphere) {
  for (const double ratio : {1.05, 1.1, 1.5, 2.5}) {
    Contact contact;
    contact.stiffness = 1e3;
    contact.restitution = 1.0;
    contact.sliding_friction = 0.0;
    contact.time_step = 5e-5;
    const double speed = 0.2;
    Engine engine = engine_with(contact, {{Wall::Kind::cylinder, 0, 1.0, ratio * radius}},
                                {{{0.01 * radius, 0, 0.1}, {0.6 * speed, 0.8 * speed, 0}, {}, radius, density}});
    double deepest = 0.0;
    for (int k = 0; k < 20000; ++k) {
      engine.step();
      const auto& x = engine.particles.position;
      deepest = std::max(deepest, std::hypot(x.x[0], x.y[0]) - (ratio - 1.0) * radius);
    }
    const double most = speed * std::sqrt(mass / contact.stiffness);
    EXPECT_LT(deepest, 1.1 * most) << ratio;
    EXPECT_GT(deepest, 0.5 * most) << ratio;
  }
}

// What the walls have as the spheres have it changes no bit.
TEST(WallContact, TheValuesOfTheSpheresAreTheDefault) {
  for (const std::string law : {"linear", "hertz"}) {
    Contact contact = contact_of(law), same = contact;
    same.wall.restitution = same.restitution;
    same.wall.sliding_friction = same.sliding_friction;
    same.wall.rolling_friction = same.rolling_friction;
    if (law == "linear") same.wall.stiffness = same.stiffness;
    std::vector<double> ends;
    for (const Contact& c : {contact, same}) {
      Engine engine = engine_with(c, {floor_at_zero}, {{{0, 0, radius}, {0.3, 0.1, -0.5}, {9, 8, 7}, radius, density}});
      engine.advance(3000);
      for (const auto* field :
           {&engine.particles.position, &engine.particles.velocity, &engine.particles.angular_velocity})
        ends.insert(ends.end(), {field->x[0], field->y[0], field->z[0]});
    }
    for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(ends[k], ends[k + 9]) << law;
  }
}

}  // namespace
}  // namespace slfb::dem
