// The derivative of the drag with respect to the slip, from dual numbers, against differences in long double.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/single_sphere/single_sphere_laws.hpp"

namespace slfb::drag {
namespace {

// Re F(Re) is the force in units that the slip does not change; fourth-order central difference.
template <class Force>
double difference(const Force& force, double reynolds) {
  const long double x = reynolds, h = 1e-4L * x;
  return static_cast<double>((8.0L * (force(x + h) - force(x - h)) - (force(x + 2.0L * h) - force(x - 2.0L * h))) /
                             (12.0L * h));
}

// Log-uniform, off the places where a law changes its form: there a difference would span two branches.
double arbitrary_reynolds() {
  const double reynolds = std::pow(10.0, *rc::gen::inRange(-2000000, 3400001) / 1e6);
  return std::abs(reynolds - 1000.0) < 1.0 ? 990.0 : reynolds;
}

TEST(SlipDerivative, OfEveryDragLawEqualsTheDifference) {
  for_each_law<DragLaws>([](const auto& law) {
    EXPECT_TRUE(rc::check(std::string(law.info.name), [&] {
      const double voidage = *rc::gen::inRange(360, 1000) / 1000.0;
      const double reynolds = arbitrary_reynolds();
      const double expected = difference(
          [&](long double re) {
            return re * law(SuspensionFlowOf<long double>{voidage, re});
          },
          reynolds);
      const double derivative = slip_derivative(law, {voidage, reynolds});
      // Where the two forms of Hill, Koch and Ladd meet within the step, the difference mixes their slopes.
      const double nearby = slip_derivative(law, {voidage, 1.0003 * reynolds});
      RC_PRE(law.info.name != "hill-koch-ladd-2001" || std::abs(nearby - derivative) < 2e-3 * derivative);
      RC_ASSERT(std::abs(derivative - expected) <= 1e-9 * std::abs(expected));
    }));
  });
}

TEST(SlipDerivative, OfEverySingleSphereLawEqualsTheDifference) {
  for_each_law<single_sphere::SingleSphereLaws>([](const auto& law) {
    EXPECT_TRUE(rc::check(std::string(law.info.name), [&] {
      const double reynolds = arbitrary_reynolds();
      const Dual force = Dual{reynolds, 1.0} * law(Dual{reynolds, 1.0});
      const double expected = difference([&](long double re) { return re * law(re); }, reynolds);
      RC_ASSERT(std::abs(force.slope - expected) <= 1e-9 * expected);
    }));
  });
}

// Creeping flow: the force is linear in the slip, so that its derivative is the law itself.
TEST(SlipDerivative, AtRestIsTheCreepingDrag) {
  for_each_law<DragLaws>([](const auto& law) {
    EXPECT_EQ(slip_derivative(law, {0.5, 0.0}), law({0.5, 0.0})) << law.info.name;
    EXPECT_NEAR(slip_derivative(law, {0.5, 1e-12}) / law({0.5, 0.0}), 1.0, 1e-5) << law.info.name;
  });
}

// Newton's regime: the force goes with the square of the slip, so that its derivative is twice the law.
TEST(SlipDerivative, InNewtonsRegimeIsTwiceTheDrag) {
  EXPECT_NEAR(slip_derivative(WenYu1966{}, {0.7, 5000.0}) / WenYu1966{}({0.7, 5000.0}), 2.0, 1e-12);
  EXPECT_NEAR(slip_derivative(Ergun1952{}, {0.5, 1e9}) / Ergun1952{}({0.5, 1e9}), 2.0, 1e-6);
}

// By hand, Ergun at e = 0.5 and Re = 100: F = 16.667 + 38.889 and F + Re dF/dRe = 16.667 + 2·38.889 = 94.444.
TEST(SlipDerivative, OfErgunByHand) { EXPECT_NEAR(slip_derivative(Ergun1952{}, {0.5, 100.0}), 94.4444, 1e-4); }

TEST(Dual, FollowsTheRulesOfDifferentiation) {
  const Dual x{2.0, 1.0};
  EXPECT_DOUBLE_EQ((x * x * x).slope, 12.0);
  EXPECT_DOUBLE_EQ((1.0 / x).slope, -0.25);
  EXPECT_DOUBLE_EQ((-x - 3.0).slope, -1.0);
  EXPECT_DOUBLE_EQ((-x - 3.0).value, -5.0);
  EXPECT_DOUBLE_EQ(sqrt(x).slope, 0.35355339059327379);   // 1/(2 sqrt 2)
  EXPECT_DOUBLE_EQ(exp(x).slope, 7.3890560989306504);     // e^2
  EXPECT_DOUBLE_EQ(log10(x).slope, 0.21714724095162591);  // 1/(2 ln 10)
  EXPECT_DOUBLE_EQ(pow(x, 3.0).slope, 12.0);
  EXPECT_DOUBLE_EQ(pow(3.0, x).slope, 9.8875105980129878);  // 9 ln 3
  EXPECT_TRUE(x > 1.0 && x <= 2.0);
}

}  // namespace
}  // namespace slfb::drag
