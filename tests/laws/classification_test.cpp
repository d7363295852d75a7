// Settling velocity of a foreign sphere through a fluidised bed: 6 mm steel in 5 mm glass and water unless said.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "correlations/classification/classification_laws.hpp"
#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/law_list.hpp"

namespace slfb::classification {
namespace {

constexpr LiquidProperties water{998.2, 1e-3};
constexpr Sphere glass{5e-3, 2230.0};
constexpr Sphere steel{6e-3, 7800.0};

// The bed of the paper at U_L, with the voidage of Eq. 36, which the printed voidages follow.
ForeignSphereInBed bed_at(double velocity, Sphere foreign = steel) {
  const double voidage = fluidisation::bed_voidage(drag::Doroodchi2012{}, glass, water, velocity, 0.35).voidage;
  return {glass, foreign, water, voidage, velocity};
}

template <class Law>
void expect_velocities(const std::map<double, double>& expected) {
  for (const auto& [velocity, settling] : expected) {
    EXPECT_NEAR(Law{}(bed_at(velocity)), settling, 6e-4) << Law::info.name << " at U_L = " << velocity;
  }
}

// Three digits, computed with a separate program from the equations as published or, where labelled, reconstructed.
TEST(ClassificationVelocity, ReproducesTheTableToItsDigits) {
  expect_velocities<KennedyBretton1966>(
      {{.06, .258}, {.07, .279}, {.08, .298}, {.09, .317}, {.10, .335}, {.11, .352}, {.12, .369}, {.24, .537}});
  expect_velocities<KuniiLevenspiel1969>({{.06, .750}, {.24, .725}});
  expect_velocities<Joshi1983Reconstruction>(
      {{.06, .227}, {.09, .282}, {.12, .331}, {.15, .374}, {.18, .415}, {.24, .488}});
  expect_velocities<DiFelice1991>(
      {{.06, .366}, {.07, .386}, {.08, .404}, {.09, .420}, {.10, .435}, {.11, .449}, {.12, .462}, {.24, .577}});
  expect_velocities<VanDerWielen1996>(
      {{.06, .152}, {.07, .160}, {.08, .168}, {.09, .175}, {.10, .183}, {.11, .191}, {.12, .199}, {.24, .323}});
}

TEST(ClassificationVelocity, GalvinByHand) {
  // e = 0.4565: rho_M = 0.4565·998.2 + 0.5435·2230 = 1667.7; (7800 - 1667.7)/6801.8 = 0.90157; ^1.39 = 0.86586;
  // u_t = 1.1589 (Brown & Lawler); 1.1589·0.86586 - 0.06/0.4565 = 1.00344 - 0.13143 = 0.8720.
  EXPECT_NEAR(Galvin1999{}(bed_at(0.06)), 0.8720, 2e-4);
}

TEST(ClassificationVelocity, VanDerWielenClosesItsForceBalanceWithinTheReportedVelocities) {
  // The balance gives 0.152 m/s at U_L = 0.06 m/s, where Table 2 of Peng 2014 has 0.097, and 0.323 against 0.422 at
  // 0.24.
  const std::vector<double> velocity{.06, .07, .08, .09, .10, .11, .12, .13, .14,
                                     .15, .16, .17, .18, .19, .20, .21, .22, .24};
  const std::vector<double> reported{.097, .147, .191, .229, .214, .216, .250, .252, .239,
                                     .268, .276, .264, .304, .359, .339, .372, .371, .422};
  double deviation = 0.0;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    deviation += std::abs(VanDerWielen1996{}(bed_at(velocity[i])) / reported[i] - 1.0);
  }
  EXPECT_NEAR(deviation / static_cast<double>(velocity.size()), 0.19, 0.006);
}

TEST(ClassificationVelocity, PseudoFluidViscosity) {
  EXPECT_NEAR(DiFelice1991::pseudo_viscosity(bed_at(0.06)), 0.074, 6e-4);
  EXPECT_NEAR(DiFelice1991::pseudo_viscosity(bed_at(0.10)), 0.039, 6e-4);
  EXPECT_NEAR(DiFelice1991::pseudo_viscosity(bed_at(0.24)), 0.0063, 6e-5);
}

TEST(ClassificationVelocity, PseudoFluidEndsWhereTheFlowIsTooFast) {
  // At e = 0.5 the bed particle needs C_D = 4/3·615.9·9.81·0.005/(1614.1 U²) = 0.024955/U². Dalla Valle's C_D is above
  // 0.63²: 0.635² at U = 0.24877 m/s has a viscosity, 0.625² at U = 0.25275 m/s has none.
  EXPECT_GT(DiFelice1991::pseudo_viscosity({glass, steel, water, 0.5, 0.24877}), 0.0);
  EXPECT_THROW(DiFelice1991::pseudo_viscosity({glass, steel, water, 0.5, 0.25275}), std::domain_error);
  EXPECT_THROW(DiFelice1991{}({glass, steel, water, 0.46, 3.0}), std::domain_error);
}

// A sphere like those of the bed hovers, as they do on average.
TEST(ClassificationVelocity, OfABedSphereIsZero) {
  EXPECT_NEAR(DiFelice1991{}(bed_at(0.09, glass)), 0.0, 1e-9);
  EXPECT_NEAR(Joshi1983Reconstruction{}(bed_at(0.09, glass)), 0.0, 1e-9);
  // For Kennedy & Bretton the bed has to expand after Richardson & Zaki: U_L = 0.4484·0.6^2.39 = 0.13227 m/s.
  EXPECT_NEAR(KennedyBretton1966{}({glass, glass, water, 0.6, 0.13227}), 0.0, 1e-4);
}

// Without a bed the sphere falls at its terminal velocity 1.1589 m/s less the upflow.
TEST(ClassificationVelocity, WithoutABedIsTheTerminalVelocity) {
  const ForeignSphereInBed empty{glass, steel, water, 1.0, 0.24};
  EXPECT_NEAR(KennedyBretton1966{}(empty), 1.1589 - 0.24, 6e-5);
  EXPECT_NEAR(Galvin1999{}(empty), 1.1589 - 0.24, 6e-5);
  EXPECT_NEAR(VanDerWielen1996{}(empty), 1.1589 - 0.24, 6e-5);
  EXPECT_NEAR(Grbavcic2009<DisplacedDrag::of_foreign_sphere>{}(empty), 1.1589 - 0.24, 6e-5);
  EXPECT_NEAR(Grbavcic2009<DisplacedDrag::of_bed_spheres>{}(empty), 1.1589 - 0.24, 6e-5);
}

// At f = 1 no collision force is left and the sphere loses the weight of the suspension it displaces: it falls like a
// sphere of density 998.2 + (7800 - rho_M) in water, whichever sphere stands in Eq. 14.
TEST(ClassificationVelocity, GrbavcicAtFullTransitionIsPureBuoyancy) {
  const ForeignSphereInBed state = bed_at(0.06);
  const Sphere equivalent{6e-3, 998.2 + 7800.0 - state.mixture_density()};
  const double expected =
      fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, equivalent, water) - 0.06 / state.voidage;
  EXPECT_NEAR(Grbavcic2009<DisplacedDrag::of_foreign_sphere>{.transition = 1.0}(state), expected, 1e-9);
  EXPECT_NEAR(Grbavcic2009<DisplacedDrag::of_bed_spheres>{.transition = 1.0}(state), expected, 1e-9);
}

TEST(ClassificationVelocity, GrbavcicBandHoldsItsEnds) {
  using Law = Grbavcic2009<DisplacedDrag::of_foreign_sphere>;
  for (const double velocity : {0.06, 0.12, 0.24}) {
    const ForeignSphereInBed state = bed_at(velocity);
    const VelocityBand band = Law::band(state);
    EXPECT_LT(band.lower, band.upper);
    EXPECT_EQ(band.lower, Law{.transition = 0.0}(state));    // the strongest braking
    EXPECT_EQ(Law{}(state), Law{.transition = 0.5}(state));  // assumed midway
    for (const double transition : {0.0, 0.3, 1.0}) {
      EXPECT_GE(Law{.transition = transition}(state), band.lower - 1e-3);
      EXPECT_LE(Law{.transition = transition}(state), band.upper + 1e-3);
    }
  }
}

TEST(ClassificationVelocity, LawsRefuseASphereThatFloats) {
  const ForeignSphereInBed floating{glass, {6e-3, 900.0}, water, 0.5, 0.06};
  EXPECT_THROW(KuniiLevenspiel1969{}(floating), std::domain_error);
  EXPECT_THROW(Joshi1983Reconstruction{}(floating), std::domain_error);
  EXPECT_THROW(KennedyBretton1966{}(floating), std::domain_error);
  EXPECT_THROW(Galvin1999{}(floating), std::domain_error);
  EXPECT_THROW(DiFelice1991{}(floating), std::domain_error);
}

}  // namespace
}  // namespace slfb::classification
