// Squeeze force against Brenner's exact series and against the integral of Reynolds' equation.
#include "solver/dem/lubrication.hpp"

#include <gtest/gtest.h>

namespace slfb::dem {
namespace {

constexpr double viscosity = 0.01, radius = 2.5e-3;

// Values printed in many places (Brenner 1961, table 1): 1.1252 at h/r = 9.0677 (cosh 3), 3.0361 at 0.5431 (cosh 1);
// far off 1 + 9/8 r/l, Lorentz 1907.
TEST(BrennerSeries, HasThePrintedValuesAndLorentzFarOff) {
  EXPECT_NEAR(brenner_wall_drag(std::cosh(1.0) - 1.0), 3.0361, 1e-4);
  EXPECT_NEAR(brenner_wall_drag(std::cosh(3.0) - 1.0), 1.1252, 1e-4);
  EXPECT_NEAR(brenner_wall_drag(999.0), 1.0 + 9.0 / 8.0 / 1000.0, 2e-6);
}

// Cox & Brenner (1967): λ = r/h + ln(r/h)/5 + 0.9713 close to the wall.
TEST(BrennerSeries, HasTheAsymptoteOfTheGap) {
  for (const double gap : {1e-5, 1e-4, 1e-3})
    EXPECT_NEAR(brenner_wall_drag(gap), 1.0 / gap - 0.2 * std::log(gap) + 0.9713, 2.0 * std::sqrt(gap)) << gap;
}

// What the leading term leaves out at a wall, from the exact series: 0.03 % of the force at 1e-4 radii, 0.3 % at 1e-3,
// 2 % at 1e-2, 12 % at 0.1.
TEST(Lubrication, IsBrennersForceCloseToAWall) {
  const Lubrication law(viscosity, 1e-6 * radius, 1e6 * radius);
  const double stokes = 6.0 * std::numbers::pi * viscosity * radius;
  for (const auto& [gap, left_out] : {std::pair{1e-4, 3e-4}, {1e-3, 3e-3}, {1e-2, 2e-2}, {0.1, 0.13}}) {
    const double exact = stokes * brenner_wall_drag(gap);
    const double deviation = law.repulsion(gap * radius, radius, 1.0) / exact - 1.0;
    EXPECT_LT(deviation, 0.0) << gap;
    EXPECT_NEAR(deviation, 0.0, left_out) << gap;
  }
}

// Between two unequal spheres: Reynolds' equation for the gap h + s²/(2 R) gives the pressure 3 μ v R/(h + s²/2R)²,
// whose integral over the plane is the force; done by midpoints in s here. Two equal spheres: 3/2 π μ r² v/h.
TEST(Lubrication, IsTheIntegralOfReynoldsEquation) {
  const double first = radius, second = 0.4 * radius, gap = 1e-4 * radius, approach = 0.02;
  const double curvature = 0.5 / first + 0.5 / second;  // of the gap: h + s² (1/2r₁ + 1/2r₂)
  double force = 0.0;
  const int pieces = 200000;
  const double outer = 60.0 * std::sqrt(gap / curvature);
  double pressure = 0.0;  // from outside in: dp/ds = −6 μ v s/H³
  for (int k = pieces - 1; k >= 0; --k) {
    const double ds = outer / pieces, s = (k + 0.5) * ds, height = gap + curvature * s * s;
    const double step = 6.0 * viscosity * approach * s / std::pow(height, 3) * ds;
    force += (pressure + 0.5 * step) * 2.0 * std::numbers::pi * s * ds;
    pressure += step;
  }
  const Lubrication law(viscosity, 1e-6 * radius, 1e6 * radius);
  EXPECT_NEAR(law.repulsion(gap, reduced_radius(first, second), approach), force, 1e-3 * force);
  const double equal = 1.5 * std::numbers::pi * viscosity * radius * radius * approach / gap;
  EXPECT_NEAR(law.repulsion(gap, reduced_radius(radius, radius), approach), equal, 1e-9 * equal);
}

TEST(Lubrication, BeginsWithoutAStepAndEndsAtTheRoughness) {
  const Lubrication law(viscosity, 1e-3 * radius, 0.1 * radius);
  EXPECT_EQ(law.coefficient(0.1 * radius, radius), 0.0);
  EXPECT_EQ(law.coefficient(radius, radius), 0.0);
  EXPECT_LT(law.coefficient(0.0999 * radius, radius), 1e-3 * law.coefficient(0.05 * radius, radius) * 10.0);
  const double most = law.coefficient(1e-3 * radius, radius);
  EXPECT_EQ(law.coefficient(0.0, radius), most);
  EXPECT_EQ(law.coefficient(-1e-4 * radius, radius), most);
}

// It takes energy whichever way the spheres go.
TEST(Lubrication, Dissipates) {
  const Lubrication law(viscosity, 1e-3 * radius, 0.1 * radius);
  EXPECT_GT(law.repulsion(0.01 * radius, radius, 0.1), 0.0);
  EXPECT_LT(law.repulsion(0.01 * radius, radius, -0.1), 0.0);
}

}  // namespace
}  // namespace slfb::dem
