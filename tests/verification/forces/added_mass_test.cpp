// Added mass against exact potential flow.
#include "solver/coupling/forces/added_mass.hpp"

#include <gtest/gtest.h>

namespace slfb::coupling {
namespace {

constexpr double density = 1000.0, volume = 1e-8, gravity = 9.81;

// A bubble without mass starts with 2 g.
TEST(AddedMass, ABubbleStartsWithTwiceGravity) {
  const AddedMass added{0.5, density, volume};
  EXPECT_NEAR(density * volume * gravity / (0.0 + added.inertia()), 2.0 * 9.81, 1e-12);
}

// In liquid that accelerates as a whole a neutral sphere goes with it and a bubble accelerates three times as fast
// (Batchelor 1967, § 6.8). The pressure gradient pushes with ρ V Du/Dt.
TEST(AddedMass, InAcceleratingLiquid) {
  const AddedMass added{0.5, density, volume};
  const Vec3 liquid{1.0, -2.0, 3.0};
  const Vec3 force = density * volume * liquid + added.force_of_liquid(liquid);
  const auto acceleration = [&](double mass) { return 1.0 / (mass + added.inertia()) * force; };
  EXPECT_NEAR(acceleration(density * volume).y, liquid.y, 1e-12);
  EXPECT_NEAR(acceleration(0.0).x, 3.0 * liquid.x, 1e-12);
  EXPECT_NEAR(acceleration(0.0).z, 3.0 * liquid.z, 1e-12);
}

}  // namespace
}  // namespace slfb::coupling
