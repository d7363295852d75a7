// Pair distribution, collision frequency, collision force and wet restitution.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>
#include <vector>

#include "correlations/collision/collision_laws.hpp"
#include "correlations/collision/stokes_number.hpp"
#include "correlations/law_list.hpp"

namespace slfb::collision {
namespace {

constexpr LiquidProperties water{998.2, 1e-3};
constexpr Sphere glass{5e-3, 2230.0};
constexpr Sphere steel{6e-3, 7800.0};

ForeignSphereInBed bed_at(double voidage) { return {glass, steel, water, voidage, 0.06}; }

TEST(RadialDistribution, AtTwoSolidsFractions) {
  // By hand: Carnahan–Starling at 0.5: 0.75/0.125 = 6; at 0.3: 0.85/0.343 = 2.478.
  EXPECT_NEAR(LunSavage1986{}(0.3), 2.887, 6e-4);
  EXPECT_NEAR(LunSavage1986{}(0.5), 18.69, 6e-3);
  EXPECT_NEAR(LunSavage1986{.packed_solids = 0.64}(0.3), 2.751, 6e-4);
  EXPECT_NEAR(LunSavage1986{.packed_solids = 0.64}(0.5), 11.38, 6e-3);
  EXPECT_NEAR(SinclairJackson1989{}(0.3), 5.129, 6e-4);
  EXPECT_NEAR(SinclairJackson1989{}(0.5), 21.97, 6e-3);
  EXPECT_NEAR(SinclairJackson1989{}(0.05), 1.80, 6e-3);
  EXPECT_NEAR(DingGidaspow1990{}(0.3), 3.08, 6e-3);
  EXPECT_NEAR(DingGidaspow1990{}(0.5), 13.2, 6e-2);
  EXPECT_NEAR(CarnahanStarling1969{}(0.3), 2.478, 6e-4);
  EXPECT_NEAR(CarnahanStarling1969{}(0.5), 6.0, 1e-12);
  EXPECT_NEAR(MaAhmadi1986{}(0.3), 2.449, 6e-4);
  EXPECT_NEAR(MaAhmadi1986{}(0.5), 6.054, 6e-4);
  EXPECT_NEAR(Torquato1995{}(0.3), 2.478, 6e-4);
  EXPECT_NEAR(Torquato1995{}(0.5), 6.061, 6e-4);
}

TEST(RadialDistribution, LebowitzByHand) {
  // a = 0.4, r = 1.2: 1/0.6 + 3·0.4·1.2/(0.36·2.2) = 1.66667 + 1.81818 = 3.48485.
  EXPECT_NEAR(Lebowitz1964{}(0.4), 3.48485, 1e-5);
  // A point among spheres (r = 0) sees only the free volume: 1/0.6.
  EXPECT_NEAR(Lebowitz1964{.diameter_ratio = 0.0}(0.4), 1.66667, 1e-5);
}

TEST(RadialDistribution, DiluteLimit) {
  // Hard spheres tend to 1 + 2.5 a; the forms in the cube root of a do not, and Ding & Gidaspow's starts at 0.6.
  for_each_law<RadialDistributionLaws>([](const auto& law) {
    const bool is_sinclair = law.info.name == "sinclair-jackson-1989";
    const bool is_ding = law.info.name == "ding-gidaspow-1990";
    EXPECT_NEAR(law(0.0), is_ding ? 0.6 : 1.0, 1e-12) << law.info.name;
    if (is_sinclair || is_ding) return;
    const double slope = law.info.name == "lebowitz-1964" ? 1.0 + 3.0 * 1.2 / 2.2 : 2.5;
    EXPECT_NEAR((law(1e-4) - 1.0) / 1e-4, slope, 2e-3) << law.info.name;
  });
}

TEST(RadialDistribution, IsInfiniteFromThePackingOn) {
  EXPECT_TRUE(std::isinf(LunSavage1986{}(0.575)));
  EXPECT_TRUE(std::isinf(SinclairJackson1989{}(0.6)));
  EXPECT_TRUE(std::isinf(DingGidaspow1990{}(0.6)));
  EXPECT_TRUE(std::isinf(MaAhmadi1986{}(0.645)));
  EXPECT_TRUE(std::isfinite(MaAhmadi1986{}(0.643)));
  EXPECT_TRUE(std::isinf(Torquato1995{}(0.64)));
}

TEST(RadialDistribution, GrowsWithTheSolids) {
  for_each_law<RadialDistributionLaws>([](const auto& law) {
    EXPECT_TRUE(rc::check(std::string(law.info.name), [&] {
      const double solids = *rc::gen::inRange(0, 57000) / 1e5;
      RC_ASSERT(law(solids + 1e-3) > law(solids));
    }));
  });
}

struct FrequencyRow {
  double solids;
  double lun_savage, lun_savage_loose, sinclair_jackson, carnahan_starling, ma_ahmadi;
};

// f* = 24 sqrt(2/(3 pi)) a g0 = 11.0558 a g0, computed with a separate program.
TEST(CollisionFrequency, ReproducesTheTableToItsDigits) {
  const std::vector<FrequencyRow> table{
      {.10, 1.46, 1.45, 2.50, 1.44, 1.44},      {.20, 4.09, 4.03, 7.45, 3.89, 3.87},
      {.30, 9.58, 9.13, 17.01, 8.22, 8.12},     {.40, 24.45, 21.24, 38.81, 16.38, 16.04},
      {.42, 30.57, 25.64, 46.71, 18.80, 18.41}, {.45, 44.62, 34.73, 63.41, 23.17, 22.79},
      {.50, 103.3, 62.9, 121.4, 33.2, 33.5},    {.52, 167.8, 83.7, 174.4, 38.5, 39.7},
      {.535, 272.9, 106.6, 249.1, 43.1, 45.6},  {.54, 333.7, 116.4, 288.2, 44.8, 47.9}};
  auto dimensionless = [](double solids, double contact_value) {
    // q2 = 4e-3 m²/s² and d = 5 mm cancel in f*.
    const CollisionState state{solids, 5e-3, 5e-3, 4e-3, 0.0, contact_value};
    return dimensionless_frequency(Simonin1991{}(state), state);
  };
  for (const FrequencyRow& row : table) {
    const double tolerance = row.solids < 0.46 ? 6e-3 : 6e-2;
    const double a = row.solids;
    EXPECT_NEAR(dimensionless(a, LunSavage1986{}(a)), row.lun_savage, tolerance) << a;
    EXPECT_NEAR(dimensionless(a, LunSavage1986{.packed_solids = 0.64}(a)), row.lun_savage_loose, tolerance) << a;
    EXPECT_NEAR(dimensionless(a, SinclairJackson1989{}(a)), row.sinclair_jackson, tolerance) << a;
    EXPECT_NEAR(dimensionless(a, CarnahanStarling1969{}(a)), row.carnahan_starling, tolerance) << a;
    EXPECT_NEAR(dimensionless(a, MaAhmadi1986{}(a)), row.ma_ahmadi, tolerance) << a;
  }
  EXPECT_NEAR(dimensionless(0.5374, LunSavage1986{}(0.5374)), 300.0, 1.0);
}

// For like spheres Eq. 2 over n_2 and Eq. 6 are one law.
TEST(CollisionFrequency, EquationsTwoAndSixAgree) {
  // a = 0.3, d = 5 mm, T = 1e-3 m²/s² so q2 = 1.5e-3, g0 = 1: 24·0.3·sqrt(1e-3/pi)/0.005 = 25.6914 1/s.
  CollisionState state{0.3, 5e-3, 5e-3, 1.5e-3, 0.0, 1.0};
  EXPECT_NEAR(Gidaspow1994{}(state), 25.6914, 6e-5);
  EXPECT_NEAR(Simonin1991{}(state), 25.6914, 6e-5);
  // A larger foreign sphere is hit more often, by (d12/d1)² = (5.5/5)² = 1.21.
  state.foreign_diameter = 6e-3;
  EXPECT_NEAR(Gidaspow1994{}(state), 1.21 * 25.6914, 1e-4);
}

TEST(CollisionFrequency, DriftByHand) {
  // a = 0.42, 6 mm in 5 mm at U_r = 0.216 m/s: n1 = 6·0.42/(pi·1.25e-7) = 6.4171e6 1/m³, and
  // pi·6.4171e6·(5.5e-3)²·0.216 = 131.7 1/s.
  EXPECT_NEAR(Gjaltema1997{}({0.42, 5e-3, 6e-3, 1e-3, 0.216, 1.0}), 131.7, 0.1);
}

// A state that says nothing of drift, crowding or the fluctuation of the foreign sphere has none.
TEST(CollisionFrequency, WhatAStateDoesNotNameIsAbsent) {
  const CollisionState state{.solids = 0.3, .bed_diameter = 5e-3, .foreign_diameter = 5e-3, .kinetic_energy = 1.5e-3};
  EXPECT_EQ(Gjaltema1997{}(state), 0.0);
  EXPECT_NEAR(Simonin1991{}(state), 25.6914, 6e-5);                           // g0 = 1
  EXPECT_NEAR(Gidaspow1994Unequal{}(state), 25.6914 / std::sqrt(2.0), 6e-5);  // half of the variance
}

TEST(StokesNumber, ByHand) {
  // 2230·sqrt(1e-3)·0.005/(9·1e-3) = 2230·0.0316228·0.555556 = 39.18
  EXPECT_NEAR(stokes_number(glass, water, 1e-3), 39.18, 5e-3);
}

TEST(CollisionForce, PengAtItsTwoLimits) {
  // 1.08 + 0.26 - 1.34 = 0 without a bed; 1.08 + 0.1105 - 0.242038 = 0.948463 in the packed one.
  EXPECT_NEAR(Peng2014{}(bed_at(1.0), 0.0), 0.0, 1e-12);
  EXPECT_NEAR(Peng2014{}(bed_at(0.425), 0.0), 0.9485, 6e-5);
}

TEST(CollisionForce, VanDerWielenAtTheVelocitiesOfThePaper) {
  // By hand at U_L = 0.06: 10.5·(5/6)^0.95 = 8.830; 8.830·0.5435·0.097 = 0.4655.
  const VanDerWielen1996 law;
  EXPECT_NEAR(VanDerWielen1996::coefficient(bed_at(0.5)), 8.830, 6e-4);
  const std::vector<double> voidage{.4565, .4846, .5105, .5347, .5574, .5789, .5993, .7929};
  const std::vector<double> velocity{.097, .147, .191, .229, .214, .216, .250, .422};
  const std::vector<double> expected{.465, .669, .826, .941, .836, .803, .885, .772};
  for (std::size_t i = 0; i < voidage.size(); ++i) {
    EXPECT_NEAR(law(bed_at(voidage[i]), velocity[i]), expected[i], 8e-4) << voidage[i];
  }
}

TEST(CollisionForce, GrbavcicReproducesTheTableToItsDigits) {
  // Over (1 - f) at f = 1/2.
  const std::vector<double> voidage{.42, .46, .50, .55, .60, .65, .70, .75, .80, .85, .90, .95};
  const std::vector<double> foreign{.081, .116, .160, .224, .298, .375, .447, .504, .531, .511, .428, .264};
  const std::vector<double> bed{.008, .012, .017, .023, .031, .039, .047, .052, .055, .053, .045, .027};
  const Grbavcic2009<DisplacedDrag::of_foreign_sphere> foreign_reading{.transition = 0.5};
  const Grbavcic2009<DisplacedDrag::of_bed_spheres> bed_reading{.transition = 0.5};
  for (std::size_t i = 0; i < voidage.size(); ++i) {
    EXPECT_NEAR(foreign_reading(bed_at(voidage[i])) / 0.5, foreign[i], 6e-4) << voidage[i];
    EXPECT_NEAR(bed_reading(bed_at(voidage[i])) / 0.5, bed[i], 6e-4) << voidage[i];
  }
}

TEST(CollisionForce, GrbavcicBand) {
  using Law = Grbavcic2009<DisplacedDrag::of_foreign_sphere>;
  const ForceBand band = Law::band(bed_at(0.6));
  EXPECT_EQ(band.lower, 0.0);
  EXPECT_EQ(band.upper, Law{.transition = 0.0}(bed_at(0.6)));
  EXPECT_EQ(Law{}(bed_at(0.6)), Law{.transition = 0.5}(bed_at(0.6)));  // assumed midway
  double previous = band.upper;
  for (const double transition : {0.25, 0.5, 0.75, 1.0}) {
    const double force = Law{.transition = transition}(bed_at(0.6));
    EXPECT_LT(force, previous);
    previous = force;
  }
}

TEST(CollisionForce, VanishesWithoutABedInEveryLaw) {
  for_each_law<CollisionForceLaws>(
      [](const auto& law) { EXPECT_NEAR(law(bed_at(1.0), 0.5), 0.0, 1e-12) << law.info.name; });
}

TEST(WetRestitution, LegendreAgainstTheStokesNumber) {
  // exp(-35/St*), St* = (rho_P + rho/2) U d/(9 mu): speeds chosen for St* = 20 … 500.
  const std::vector<double> stokes{20, 27, 50, 65, 100, 152, 500};
  const std::vector<double> expected{.17, .27, .50, .58, .71, .79, .93};
  for (std::size_t i = 0; i < stokes.size(); ++i) {
    const double speed = stokes[i] * 9.0 * 1e-3 / ((2230.0 + 499.1) * 5e-3);
    EXPECT_NEAR(Legendre2005{}({glass, water, speed, 0.0}), expected[i], 6e-3) << stokes[i];
  }
}

TEST(WetRestitution, LubricationByHand) {
  // St = 2230·0.1·0.005/0.009 = 123.889; ln(2·1e-6/5e-3) = ln 4e-4 = -7.82405; 1 - 0.063154 = 0.936846.
  EXPECT_NEAR(BarnockyDavis1988{}({glass, water, 0.1, 1e-6}), 0.936846, 1e-6);
  EXPECT_EQ(BarnockyDavis1988{}({glass, water, 0.001, 1e-6}), 0.0);  // St = 1.2: stuck
}

TEST(WetRestitution, TendsToTheDryValueAndGrowsWithTheSpeed) {
  for_each_law<RestitutionLaws>([](const auto& law) {
    EXPECT_NEAR(law(WetImpact{glass, water, 1e6, 1e-6}), 1.0, 1e-4) << law.info.name;
    EXPECT_LT(law(WetImpact{glass, water, 0.05, 1e-6}), law(WetImpact{glass, water, 0.1, 1e-6})) << law.info.name;
  });
}

}  // namespace
}  // namespace slfb::collision
