// Lift in shear against Saffman's number, its direction, and the properties of Mei's correction.
#include "solver/coupling/forces/saffman_lift.hpp"

#include "tests/verification/forces/vectors.hpp"

namespace slfb::coupling {
namespace {

constexpr LiquidProperties liquid{1000.0, 0.01};
constexpr double diameter = 1e-3;

// u = κ y along x: vorticity −κ along z. Saffman (1965, 1968): 6.46 μ r² w √(κ/ν), towards the streamlines of the
// faster liquid (+y) for a sphere that lags, w = u − v > 0.
TEST(SaffmanLift, HasTheSizeAndTheDirectionOfSaffman) {
  const double shear = 0.02, slip = 1e-4, radius = 0.5 * diameter;
  const double size =
      6.46 * liquid.viscosity * radius * radius * slip * std::sqrt(shear * liquid.density / liquid.viscosity);
  const Vec3 lags = saffman_lift({slip, 0, 0}, {0, 0, -shear}, diameter, liquid);
  expect_near(lags, {0, size, 0}, 1e-4 * size);
  const Vec3 leads = saffman_lift({-slip, 0, 0}, {0, 0, -shear}, diameter, liquid);
  expect_near(leads, {0, -size, 0}, 1e-4 * size);
}

TEST(SaffmanLift, TurnsWithTheFlow) {
  const Vec3 slip{0.01, -0.02, 0.005}, vorticity{1.0, 3.0, -2.0};
  for (const auto law : {saffman_lift, mei_lift}) {
    const Vec3 lift = law(slip, vorticity, diameter, liquid);
    expect_near(law(turned(slip), turned(vorticity), diameter, liquid), turned(lift), 1e-12 * norm(lift));
    EXPECT_NEAR(dot(lift, slip) / norm(lift) / norm(slip), 0.0, 1e-12);
    EXPECT_GT(norm(lift), 0.0);
  }
}

TEST(SaffmanLift, VanishesWithoutSlipOrShear) {
  for (const auto law : {saffman_lift, mei_lift}) {
    EXPECT_EQ(norm(law({0, 0, 0}, {1, 2, 3}, diameter, liquid)), 0.0);
    EXPECT_EQ(norm(law({0.1, 0, 0}, {0, 0, 0}, diameter, liquid)), 0.0);
  }
}

// Saffman's own limit at small Re; Dandy & Dwyer's branch 0.0524 √(β Re) goes on where the first has forgotten Saffman:
// 0.3314 = 0.0524 √40 within the printed digits.
TEST(MeiLift, BeginsAsSaffmanAndJoinsDandyAndDwyer) {
  for (const double beta : {0.005, 0.1, 0.4}) {
    EXPECT_NEAR(mei_lift_ratio(1e-6, 2.0 * beta * 1e-6), 1.0, 1e-6);
    const auto at = [&](double reynolds) { return mei_lift_ratio(reynolds, 2.0 * beta * reynolds); };
    EXPECT_NEAR(at(40.0) - at(40.001), std::exp(-4.0) * (1.0 - std::sqrt(beta) * 0.3314), 2e-4) << beta;
    double before = 1.1;
    for (const double reynolds : {0.1, 1.0, 5.0, 20.0}) {
      EXPECT_LT(at(reynolds), before);
      before = at(reynolds);
    }
  }
  // By hand: β = 0.1, Re = 10: √β = 0.316228, 0.104798; 0.895202 × 0.367879 + 0.104798 = 0.434124.
  EXPECT_NEAR(mei_lift_ratio(10.0, 2.0), 0.434124, 1e-6);
  // Above 40 by hand: β = 0.1, Re = 90: 0.0524 × 3.
  EXPECT_NEAR(mei_lift_ratio(90.0, 18.0), 0.1572, 1e-6);
}

}  // namespace
}  // namespace slfb::coupling
