// Lift and torque on a spinning sphere against creeping-flow results and limits.
#include "solver/coupling/forces/magnus_lift.hpp"

#include "tests/verification/forces/vectors.hpp"

namespace slfb::coupling {
namespace {

constexpr LiquidProperties liquid{1000.0, 0.01};
constexpr double diameter = 2e-3, radius = 1e-3;

// Rubinow & Keller (1961): a sphere that moves with V in liquid at rest and spins with Ω feels π r³ ρ Ω × V.
TEST(MagnusLift, IsThatOfRubinowAndKeller) {
  const Vec3 spin{0, 0, 5.0}, velocity{0.01, 0, 0};
  const Vec3 lift = rubinow_keller_lift(relative_rotation({}, spin), -1.0 * velocity, diameter, liquid);
  const double size = std::numbers::pi * std::pow(radius, 3) * liquid.density * 5.0 * 0.01;
  expect_near(lift, {0, size, 0}, 1e-12 * size);
}

// A sphere that turns with the liquid, Ω = ½ ω, feels neither lift nor torque: a fluid element would do the same.
TEST(MagnusLift, VanishesWhereTheSphereTurnsWithTheLiquid) {
  const Vec3 vorticity{2.0, -4.0, 6.0};
  const Vec3 rotation = relative_rotation(vorticity, {1.0, -2.0, 3.0});
  EXPECT_EQ(norm(rubinow_keller_lift(rotation, {0.1, 0.2, 0.3}, diameter, liquid)), 0.0);
  EXPECT_EQ(norm(oesterle_bui_dinh_lift(rotation, {0.1, 0.2, 0.3}, diameter, liquid)), 0.0);
  EXPECT_EQ(norm(viscous_torque(rotation, diameter, liquid)), 0.0);
}

TEST(MagnusLift, TurnsWithTheFlow) {
  const Vec3 rotation{10.0, -20.0, 30.0}, slip{0.1, 0.05, -0.02};
  for (const auto law : {rubinow_keller_lift, oesterle_bui_dinh_lift}) {
    const Vec3 lift = law(rotation, slip, diameter, liquid);
    expect_near(law(turned(rotation), turned(slip), diameter, liquid), turned(lift), 1e-12 * norm(lift));
  }
  const Vec3 torque = viscous_torque(rotation, diameter, liquid);
  expect_near(viscous_torque(turned(rotation), diameter, liquid), turned(torque), 1e-12 * norm(torque));
}

// Oesterlé & Bui Dinh lead over to Rubinow and Keller where Re → 0, and to the coefficient 0.45 of ½ ρ π r² w² at high
// Re.
TEST(MagnusLift, OesterleAndBuiDinhHaveBothLimits) {
  const Vec3 slow{1e-7, 0, 0}, turning{0, 0, 1e-4};
  const double creeping = norm(rubinow_keller_lift(turning, slow, diameter, liquid));
  EXPECT_NEAR(norm(oesterle_bui_dinh_lift(turning, slow, diameter, liquid)), creeping, 1e-3 * creeping);
  const Vec3 fast{100.0, 0, 0}, spinning{0, 0, 2e5};
  const double dynamic = 0.5 * liquid.density * std::numbers::pi * radius * radius * 100.0 * 100.0;
  EXPECT_NEAR(norm(oesterle_bui_dinh_lift(spinning, fast, diameter, liquid)), 0.45 * dynamic, 1e-6 * dynamic);
}

// Kirchhoff: 8 π μ r³ of relative rotation; Dennis et al. print 6.45/√R + 32.1/R with R = Ω r²/ν; its leading term is
// the boundary layer of a spinning sphere; the two meet near R = 8.
TEST(ViscousTorque, IsKirchhoffThenDennis) {
  const double kirchhoff = 8.0 * std::numbers::pi * liquid.viscosity * std::pow(radius, 3);
  EXPECT_NEAR(viscous_torque({0, 0.3, 0}, diameter, liquid).y, 0.3 * kirchhoff, 1e-12 * kirchhoff);
  const double nu = liquid.viscosity / liquid.density;
  for (const double reynolds : {20.0, 100.0, 1000.0}) {
    const double spin = reynolds * nu / (radius * radius);
    const double scale = 0.5 * liquid.density * std::pow(radius, 5) * spin * spin;
    EXPECT_NEAR(viscous_torque({spin, 0, 0}, diameter, liquid).x,
                (6.45 / std::sqrt(reynolds) + 32.1 / reynolds) * scale, 1e-6 * scale);
  }
  const double meeting = 8.0 * nu / (radius * radius);
  const double below = viscous_torque({0.9999 * meeting, 0, 0}, diameter, liquid).x;
  const double above = viscous_torque({1.0001 * meeting, 0, 0}, diameter, liquid).x;
  EXPECT_NEAR(above / below, 1.0, 4e-3);
}

// The torque takes the relative rotation away: it points along the turning of the liquid.
TEST(ViscousTorque, SlowsASpinInLiquidAtRest) {
  EXPECT_LT(viscous_torque(relative_rotation({}, {0, 0, 7.0}), diameter, liquid).z, 0.0);
  EXPECT_GT(viscous_torque(relative_rotation({0, 0, 7.0}, {}), diameter, liquid).z, 0.0);
}

}  // namespace
}  // namespace slfb::coupling
