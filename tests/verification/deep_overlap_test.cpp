// Overlaps that are no longer small against a radius are noted, and end the motion where they make no sense.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/few_spheres.hpp"

namespace slfb::dem {
namespace {

constexpr double radius = 0.0025, density = 2230.0, speed = 0.5;

/// Two spheres that meet; elastic, so that they overlap by v √(m_eff/k), `share` of the radius, and part again.
Engine meeting(double share) {
  const double mass = density * Particles::volume_of(radius);
  Contact contact;
  contact.restitution = 1.0;
  contact.stiffness = 0.5 * mass * std::pow(speed / (share * radius), 2);
  contact.time_step = 0.002 * std::sqrt(0.5 * mass / contact.stiffness);
  return engine_with(contact, {},
                     {{{0, 0, 0.1}, {0, 0, 0.5 * speed}, {}, radius, density},
                      {{0, 0, 0.1 + 2.0 * radius}, {0, 0, -0.5 * speed}, {}, radius, density}});
}

// All steps are looked at, not only the last of a call.
TEST(DeepOverlap, IsNotedAtItsDeepest) {
  for (const double share : {0.25, 0.5, 0.9}) {
    Engine engine = meeting(share);
    engine.advance(3000);
    EXPECT_TRUE(engine.touching_pairs().empty());
    const auto deepest = engine.take_deepest_contact();
    ASSERT_TRUE(deepest.has_value()) << share;
    EXPECT_NEAR(deepest->share, share, 1e-3);
    EXPECT_FALSE(deepest->at_wall);
    EXPECT_EQ(deepest->first + deepest->second, 1U);
    EXPECT_FALSE(engine.take_deepest_contact().has_value()) << "it has been taken";
  }
}

TEST(DeepOverlap, IsNothingWhereOverlapsAreSmall) {
  Engine engine = meeting(0.95 * Engine::deep_overlap);
  engine.advance(3000);
  EXPECT_FALSE(engine.take_deepest_contact().has_value());
}

TEST(DeepOverlap, OfAWholeRadiusIsAnError) {
  Engine engine = meeting(1.1);
  try {
    engine.advance(3000);
    FAIL() << "one sphere has swallowed half of the other";
  } catch (const EngineError& error) {
    EXPECT_NE(std::string(error.what()).find("overlaps another by the whole of the smaller radius"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace slfb::dem
