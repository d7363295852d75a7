// Drag and terminal velocity of one sphere.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "correlations/drag/single_sphere/single_sphere_laws.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"

namespace slfb::drag::single_sphere {
namespace {

double coefficient(std::string_view name, double reynolds) {
  return with_single_sphere_law(name, [&](const auto& law) { return drag_coefficient(law, reynolds); });
}

// C_D at Re = 1, 100, 1000, 10000, computed with a separate program. By hand at Re = 100, Dalla Valle:
// (0.63 + 0.48)² = 1.11² = 1.2321; Abraham: 24/82.0836·(1.906)² = 0.29239·3.63284 = 1.0622.
TEST(SingleSphereLaws, ReproduceTheTableToItsDigits) {
  const std::map<std::string, std::vector<double>> table{
      {"schiller-naumann-1935", {27.600, 1.09173, 0.43829, 0.44}},
      {"brown-lawler-2003", {27.600, 1.07314, 0.46338, 0.41061}},
      {"turton-levenspiel-1986", {28.152, 1.09937, 0.45472, 0.42001}},
      {"haider-levenspiel-1989", {28.334, 1.09474, 0.45346, 0.42038}},
      {"dalla-valle-1948", {29.485, 1.23210, 0.61119, 0.45968}},
      {"clift-gauvin-1971", {27.600, 1.09379, 0.46615, 0.41672}},
      {"abraham-1970", {29.590, 1.0622, 0.48392}}};
  const std::vector<double> reynolds{1, 100, 1000, 10000};
  const std::vector<double> tolerance{6e-4, 6e-6, 6e-6, 6e-6};
  for (const auto& [name, values] : table) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double allowed = name == "abraham-1970" && i == 1 ? 6e-5 : tolerance[i];
      EXPECT_NEAR(coefficient(name, reynolds[i]), values[i], allowed) << name << " at Re = " << reynolds[i];
    }
  }
}

TEST(SingleSphereLaws, HaiderLevenspielAsAnotherLibraryStatesIt) {
  EXPECT_NEAR(coefficient("haider-levenspiel-1989", 200), 0.7959552, 1e-7);  // example of the library fluids
}

TEST(SingleSphereLaws, TendToStokesExceptDallaValle) {
  for_each_law<SingleSphereLaws>([](const auto& law) {
    const bool dalla_valle = law.info.name == "dalla-valle-1948";
    EXPECT_DOUBLE_EQ(law(0.0), dalla_valle ? 23.04 / 24.0 : 1.0) << law.info.name;
  });
}

TEST(SingleSphereLaws, StayWithinTheSpreadOfTheMeasurements) {
  // Measured C_D in Newton's regime lies between 0.38 and 0.50.
  for (const char* name : {"schiller-naumann-1935", "brown-lawler-2003", "turton-levenspiel-1986",
                           "haider-levenspiel-1989", "clift-gauvin-1971"}) {
    EXPECT_NEAR(coefficient(name, 5000), 0.41, 0.05) << name;
  }
}

TEST(SingleSphereLaws, ForceGrowsWithTheVelocity) {
  for_each_law<SingleSphereLaws>([](const auto& law) {
    EXPECT_TRUE(rc::check(std::string(law.info.name), [&] {
      const double reynolds = std::pow(10.0, *rc::gen::inRange(-4000000, 5000001) / 1e6);
      const double force = law(reynolds) * reynolds;
      RC_ASSERT(std::isfinite(force));
      RC_ASSERT(law(0.97 * reynolds) * 0.97 * reynolds < force);
    }));
  });
}

constexpr LiquidProperties water{998.2, 1e-3};
constexpr LiquidProperties sodium_iodide{1800.0, 1.8e-3};

struct SettlingRow {
  Sphere sphere;
  double water_schiller, water_brown, iodide_schiller, iodide_brown;
};

// Computed with a separate program. By hand, 6 mm steel in water with C_D = 0.44:
// sqrt(4·9.81·0.006·6801.8/(3·0.44·998.2)) = sqrt(1.21533) = 1.1024 m/s.
TEST(TerminalVelocity, ReproducesTheTableToItsDigits) {
  const std::vector<SettlingRow> table{
      {{3e-3, 2230}, .3321, .3218, .1216, .1220},   {{3e-3, 2300}, .3410, .3321, .1335, .1337},
      {{5e-3, 2230}, .4283, .4484, .1865, .1814},   {{5e-3, 2300}, .4403, .4617, .2032, .1977},
      {{3e-3, 7800}, .7795, .8199, .5452, .5601},   {{4e-3, 7800}, .9001, .9566, .6296, .6643},
      {{5e-3, 7800}, 1.0064, 1.0662, .7039, .7480}, {{6e-3, 7800}, 1.1024, 1.1589, .7711, .8181}};
  const SchillerNaumann1935 schiller;
  const BrownLawler2003 brown;
  for (const SettlingRow& row : table) {
    EXPECT_NEAR(fluidisation::terminal_velocity(schiller, row.sphere, water), row.water_schiller, 6e-5);
    EXPECT_NEAR(fluidisation::terminal_velocity(brown, row.sphere, water), row.water_brown, 6e-5);
    EXPECT_NEAR(fluidisation::terminal_velocity(schiller, row.sphere, sodium_iodide), row.iodide_schiller, 6e-5);
    EXPECT_NEAR(fluidisation::terminal_velocity(brown, row.sphere, sodium_iodide), row.iodide_brown, 6e-5);
  }
}

// ten Cate et al. (2002) state these velocities, to three digits, from Abraham's law.
TEST(TerminalVelocity, OfTheSphereOfTenCate) {
  const Sphere sphere{0.015, 1120.0};
  const Abraham1970 law;
  EXPECT_NEAR(fluidisation::terminal_velocity(law, sphere, {970, 0.373}), 0.038, 6e-4);
  EXPECT_NEAR(fluidisation::terminal_velocity(law, sphere, {965, 0.212}), 0.060, 6e-4);
  EXPECT_NEAR(fluidisation::terminal_velocity(law, sphere, {962, 0.113}), 0.091, 6e-4);
  EXPECT_NEAR(fluidisation::terminal_velocity(law, sphere, {960, 0.058}), 0.128, 6e-4);
}

TEST(TerminalVelocity, OfAFineSphereIsThatOfStokes) {
  // d = 1 µm: (2230 - 998.2)·9.81·1e-12/(18e-3) = 6.7133e-7 m/s; Re = 6.7e-7, where every law is Stokes to 1e-4.
  EXPECT_NEAR(fluidisation::terminal_velocity(BrownLawler2003{}, {1e-6, 2230}, water), 6.7133e-7, 1e-10);
}

TEST(TerminalVelocity, RefusesALightSphere) {
  try {
    fluidisation::slip_velocity(Abraham1970{}, 5e-3, water, -0.005);
    FAIL() << "a force that points upwards was accepted";
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("upwards"), std::string::npos);
  }
  EXPECT_GT(fluidisation::slip_velocity(Abraham1970{}, 5e-3, water, 0.005), 0.0);
  EXPECT_EQ(fluidisation::slip_velocity(Abraham1970{}, 5e-3, water, 0.0), 0.0);
  EXPECT_THROW(fluidisation::terminal_velocity(Abraham1970{}, {5e-3, 900}, water), std::domain_error);
}

}  // namespace
}  // namespace slfb::drag::single_sphere
