// Drag laws of suspensions against values worked out outside this code and against their limits.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "correlations/drag/drag_laws.hpp"

namespace slfb::drag {
namespace {

double dimensionless_drag(std::string_view name, double voidage, double reynolds) {
  return with_drag_law(name, [&](const auto& law) -> double { return law({voidage, reynolds}); });
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for_each_law<DragLaws>([&](const auto& law) { names.emplace_back(law.info.name); });
  return names;
}

struct TableRow {
  double voidage;
  double reynolds;
  std::vector<double> drag;
};

// F for e and Re, five digits each, computed with a separate program from the formulas as published. Three entries by
// hand: e = 0.5, Re = 100: Ergun 150·0.5/(18·0.25) + 1.75·100/(18·0.25) = 16.667 + 38.889 = 55.556;
// Wen–Yu 100/24·1.09173·0.5^-3.65 = 4.5489·12.553 = 57.10; Gibilaro (17.3 + 33.6)·0.5^-3.8/18 = 50.9·13.93/18 = 39.39.
const std::vector<std::string> table_laws{"ergun-1952",          "wen-yu-1966",   "di-felice-1994", "gibilaro-1985",
                                          "syamlal-obrien-1993", "beetstra-2007", "tang-2015",      "tenneti-2011",
                                          "hill-koch-ladd-2001", "rong-2013"};
const std::vector<TableRow> table{
    {0.40, 1, {31.858, 32.597, 30.046, 31.864, 16.696, 37.865, 40.357, 35.454, 37.565, 30.558}},
    {0.50, 10, {20.556, 21.712, 16.786, 15.987, 15.411, 22.774, 25.672, 22.371, 22.289, 17.565}},
    {0.50, 100, {55.556, 57.104, 44.830, 39.388, 54.295, 50.413, 44.443, 40.707, 42.893, 46.909}},
    {0.50, 300, {133.33, 107.32, 101.08, 91.389, 128.76, 101.33, 70.660, 72.394, 88.678, 110.43}},
    {0.60, 500, {144.29, 75.641, 83.693, 71.718, 110.23, 92.280, 60.514, 60.977, 78.679, 97.322}},
    {0.70, 300, {64.626, 31.426, 33.336, 25.445, 44.792, 40.710, 30.580, 27.517, 35.735, 37.660}},
    {0.80, 500, {78.559, 26.469, 31.622, 24.036, 44.128, 40.316, 29.176, 23.744, 40.840, 36.209}},
    {0.90, 100, {13.032, 6.6822, 7.1366, 4.2201, 8.7238, 8.5537, 8.1006, 6.7244, 8.5009, 7.4216}}};

// Five digits are printed: the value may differ by a little over half a unit in the fifth.
double printed_digit(double value) { return 0.6 * std::pow(10.0, std::floor(std::log10(value)) - 4.0); }

TEST(DragLaws, ReproduceTheTableToItsDigits) {
  for (const TableRow& row : table) {
    for (std::size_t i = 0; i < table_laws.size(); ++i) {
      EXPECT_NEAR(dimensionless_drag(table_laws[i], row.voidage, row.reynolds), row.drag[i], printed_digit(row.drag[i]))
          << table_laws[i] << " at e = " << row.voidage << ", Re = " << row.reynolds;
    }
  }
}

TEST(DragLaws, DoroodchiByHand) {
  // e = 0.5, Re = 100: (18 + 33)/18 = 2.83333; 0.5^-3.8 = 2^3.8 = 13.92881; product 39.46496.
  EXPECT_NEAR(dimensionless_drag("doroodchi-2012", 0.5, 100), 39.46496, 1e-4);
}

TEST(DragLaws, KochHillByHand) {
  // e = 0.8, s = 0.2, Re = 100. sqrt(0.1) = 0.3162278, ln 0.2 = -1.6094379.
  // numerator 1 + 0.9486833 + 2.109375·0.2·(-1.6094379) + 16.14·0.2 = 1.9486833 - 0.6789816 + 3.228 = 4.4977017
  // denominator 1 + 0.1362 - 0.3392 + 0.06528 = 0.86228; F0 = 5.2160570
  // F3 = 0.0673 + 0.0424 + 0.0232/0.32768 = 0.1805008; F = 0.8 (5.2160570 + 50·0.1805008) = 11.3928776
  EXPECT_NEAR(dimensionless_drag("koch-hill-2001", 0.8, 100), 11.39288, 1e-4);
  // e = 0.5 is above s = 0.4: F0 = 5/0.125 = 40, F3 = 0.0673 + 0.106 + 0.0232·32 = 0.9157;
  // F = 0.5 (40 + 50·0.9157) = 42.8925
  EXPECT_NEAR(dimensionless_drag("koch-hill-2001", 0.5, 100), 42.8925, 1e-9);
}

TEST(DragLaws, GidaspowBlendIsTheMeanOfBothAtTheSwitch) {
  // At e = 0.8 the weight is one half. Table values at Re = 500: Ergun 78.559, Wen–Yu 26.469; mean 52.514.
  EXPECT_NEAR(dimensionless_drag("gidaspow-1994-blend", 0.8, 500), 52.514, 1e-3);
  // Far from it the blend is within 1 % of the branch: the arctangent of 262.5·0.3 = 78.75 leaves 0.4 %.
  EXPECT_NEAR(dimensionless_drag("gidaspow-1994-blend", 0.5, 100), 55.556, 0.01 * 55.556);
}

TEST(DragLaws, GidaspowTakesErgunUpToVoidagePointEight) {
  EXPECT_EQ(dimensionless_drag("gidaspow-1994", 0.8, 500), dimensionless_drag("ergun-1952", 0.8, 500));
  EXPECT_EQ(dimensionless_drag("gidaspow-1994", 0.8001, 500), dimensionless_drag("wen-yu-1966", 0.8001, 500));
}

TEST(DragLaws, GidaspowJumpsAtVoidagePointEight) {
  const std::map<double, double> jumps{{10, 1.06}, {100, 1.73}, {500, 2.97}, {1000, 3.75}};
  for (const auto& [reynolds, jump] : jumps) {
    const double below = dimensionless_drag("gidaspow-1994", 0.8, reynolds);
    const double above = dimensionless_drag("gidaspow-1994", std::nextafter(0.8, 1.0), reynolds);
    EXPECT_NEAR(below / above, jump, 0.006) << "Re = " << reynolds;
  }
}

TEST(DragLaws, ExchangeCoefficientInSiUnits) {
  // Water, 5 mm, e = 0.5, w = 0.2 m/s, so Re = 998.2·0.005·0.5·0.2/1e-3 = 499.1. Eq. 23 in SI units:
  // 150·0.25·1e-3/(0.5·2.5e-5) + 1.75·0.5·998.2·0.2/0.005 = 3000 + 34937 = 37937 kg/(m³ s).
  EXPECT_NEAR(exchange_coefficient(dimensionless_drag("gidaspow-1994", 0.5, 499.1), 0.5, 5e-3, 1e-3), 37937.0, 0.5);
  // e = 0.9: Re = 898.38, C_D = 0.4551; 0.75·0.4551·998.2·0.9·0.1·0.2·0.9^-2.65/0.005 = 1621.7.
  EXPECT_NEAR(exchange_coefficient(dimensionless_drag("gidaspow-1994", 0.9, 898.38), 0.9, 5e-3, 1e-3), 1621.7, 0.2);
}

// What each law tends to where only one sphere is left: F in creeping flow, where one sphere has 1, and C_D at
// Re = 1000, where one sphere has 0.38 to 0.47. Several laws are not the single sphere, and should be seen not to be.
struct SingleSphereLimit {
  double creeping;
  double coefficient;
};
constexpr double infinite = std::numeric_limits<double>::infinity();
const std::map<std::string, SingleSphereLimit> single_sphere_limits{
    {"ergun-1952", {0.0, 2.33333}},                      // a packed bed knows no single sphere: 24·1.75/18
    {"ergun-1952-refit", {0.0, 2.26267}},                // 24·1.697/18
    {"eisfeld-schnitzlein-2001", {infinite, infinite}},  // a wall without spheres still drags
    {"wen-yu-1966", {1.0, 0.43829}},                     // Schiller–Naumann
    {"gidaspow-1994", {1.0, 0.43829}},                   //
    {"gidaspow-1994-blend", {0.993937, 0.44978}},        // 0.60633 % of Ergun is left: atan(52.5)/pi = 0.493937
    {"di-felice-1994", {0.96, 0.61119}},                 // Dalla Valle
    {"di-felice-1994-mfix", {1.0, 0.43829}},             //
    {"gibilaro-1985", {0.961111, 0.47107}},              // 23.07/Re + 0.448
    {"doroodchi-2012", {1.0, 0.46400}},                  // 24/Re + 0.44
    {"syamlal-obrien-1993", {0.96, 0.61119}},            // V_r = 1
    {"hill-koch-ladd-2001", {1.0, 0.46404}},             // 24 (1 + 0.03667·500)/1000
    {"koch-hill-2001", {1.0, 1.11000}},                  // 24 (1 + 0.0905·500)/1000
    {"koch-hill-2001-ladd", {1.0, 1.11000}},             //
    {"beetstra-2007", {1.0, 0.73890}},                   // 24 (1 + 17.2083 (1 + 8.4·1000^-0.343)/(1 + 1000^-0.5))/1000
    {"tang-2015", {1.0, 0.43854}},                       // 24 (1 + 1000 (-0.00456 + 0.2334·1000^-0.343))/1000
    {"tenneti-2011", {1.0, 0.43829}},                    //
    {"tenneti-2011-mfix", {1.0, 0.43829}},
    {"tenneti-2011-openfoam", {1.0, 0.43829}},
    {"rong-2013", {0.96, 0.61119}}};

TEST(DragLaws, LimitOfOneSphere) {
  for (const std::string& name : all_names()) {
    ASSERT_TRUE(single_sphere_limits.contains(name)) << name;
    const SingleSphereLimit& limit = single_sphere_limits.at(name);
    const double creeping = dimensionless_drag(name, 1.0, 0.0);
    const double coefficient = 24.0 / 1000.0 * dimensionless_drag(name, 1.0, 1000.0);
    if (std::isinf(limit.creeping)) {
      EXPECT_TRUE(std::isinf(creeping) && std::isinf(coefficient)) << name;
    } else {
      EXPECT_NEAR(creeping, limit.creeping, 1e-6) << name;
      EXPECT_NEAR(coefficient, limit.coefficient, 6e-6) << name;
    }
  }
}

// Carman's 10 s/e² for a dense bed in creeping flow is 6/0.16 = 37.5 at e = 0.4; what each law gives of it.
TEST(DragLaws, CreepingFlowLimitOfAPackedBed) {
  constexpr double carman = 37.5;
  const std::map<std::string, double> ratios{
      {"ergun-1952", 150.0 / 180.0},         //
      {"ergun-1952-refit", 151.9 / 180.0},   //
      {"eisfeld-schnitzlein-2001", 1.0562},  // 154/180·(1 + 0.2/1.8)² = 0.85556·1.234568
      {"hill-koch-ladd-2001", 1.0},          //
      {"koch-hill-2001", 1.0},               //
      {"koch-hill-2001-ladd", 1.0},          //
      {"beetstra-2007", 1.009},              // 0.16 (1 + 1.5 sqrt(0.6)) = 0.346 above Carman
      {"tang-2015", 1.009},                  // the same
      {"tenneti-2011", 0.916},               // 0.4 (15.625 + 54.469 + 15.814) = 34.363
      {"tenneti-2011-mfix", 2.291},          // without the 0.4
      {"tenneti-2011-openfoam", 0.816},      // 2.5 in place of 0.4·15.625 = 6.25: 30.613
      {"gibilaro-1985", 0.833},              // 17.3/18·2.5^3.8 = 0.9611·32.514 = 31.250: Ergun's value
      {"doroodchi-2012", 0.867},             // 2.5^3.8 = 32.514
      {"wen-yu-1966", 0.756},                // 2.5^3.65 = 28.345
      {"gidaspow-1994", 150.0 / 180.0},      // Ergun
      {"gidaspow-1994-blend", 0.8330},       // 0.30 % of Wen–Yu
      {"di-felice-1994", 0.7597},            // 0.96·2.5^3.7 = 0.96·29.674 = 28.487
      {"di-felice-1994-mfix", 0.7913},       // 29.674
      {"syamlal-obrien-1993", 1.137},        // 0.96/V_r, V_r = 0.4^4.14 = 0.022517: 42.63
      {"rong-2013", 0.767}};                 // 0.96·2.5^3.71 = 28.749
  for (const std::string& name : all_names()) {
    ASSERT_TRUE(ratios.contains(name)) << name;
    EXPECT_NEAR(dimensionless_drag(name, 0.4, 0.0) / carman, ratios.at(name), 1e-3) << name;
  }
}

TEST(DragLaws, UnknownNameListsTheKnownOnes) {
  try {
    dimensionless_drag("gidaspov", 0.5, 1.0);
    FAIL() << "an unknown name was accepted";
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("gidaspov"), std::string::npos);
    for (const std::string& name : all_names()) EXPECT_NE(message.find(name), std::string::npos) << name;
  }
}

// Voidage and Reynolds number inside the range that the law states, the latter from 0 on and spread over decades.
SuspensionFlow arbitrary_flow(const LawInfo& info) {
  const double position = *rc::gen::inRange(0, 1000001) / 1e6;
  const double decades = *rc::gen::inRange(-4000000, 4000001) / 1e6;
  const double lower = std::max(info.voidage.lower, 0.35);
  const bool still = *rc::gen::inRange(0, 10) == 0;
  return {lower + (info.voidage.upper - lower) * position,
          still ? 0.0 : std::min(std::pow(10.0, decades), info.reynolds.upper)};
}

TEST(DragLaws, AreFiniteAndPositiveInTheirRange) {
  for_each_law<DragLaws>([](const auto& law) {
    EXPECT_TRUE(rc::check(std::string(law.info.name), [&] {
      const SuspensionFlow flow = arbitrary_flow(law.info);
      const double drag = law(flow);
      RC_ASSERT(std::isfinite(drag));
      RC_ASSERT(drag > 0.0 || flow.voidage == 1.0);
    }));
  });
}

// The force, F times the slip, grows with the slip at fixed voidage.
TEST(DragLaws, ForceGrowsWithTheSlip) {
  for_each_law<DragLaws>([](const auto& law) {
    EXPECT_TRUE(rc::check(std::string(law.info.name), [&] {
      const SuspensionFlow flow = arbitrary_flow(law.info);
      RC_PRE(flow.reynolds > 0.0 && flow.voidage < 1.0);
      RC_ASSERT(law({flow.voidage, 0.97 * flow.reynolds}) * 0.97 < law(flow));
    }));
  });
}

// At fixed flow rate a denser bed drags more, which is what makes a bed expand.
TEST(DragLaws, DragGrowsWithTheCrowding) {
  for (const std::string& name : all_names()) {
    for (const double reynolds : {1.0, 100.0, 300.0}) {
      EXPECT_GT(dimensionless_drag(name, 0.42, reynolds), dimensionless_drag(name, 0.55, reynolds)) << name;
      EXPECT_GT(dimensionless_drag(name, 0.55, reynolds), dimensionless_drag(name, 0.75, reynolds)) << name;
    }
  }
}

}  // namespace
}  // namespace slfb::drag
