// Added mass against exact potential flow.
#include "solver/coupling/forces/added_mass.hpp"

#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace slfb::coupling {
namespace {

constexpr double density = 1000.0, volume = 1e-8, gravity = 9.81;

// A bubble without mass starts with 2 g.
TEST(AddedMass, ABubbleStartsWithTwiceGravity) {
  const AddedMass added{lone_sphere_added_mass, density, volume};
  EXPECT_NEAR(density * volume * gravity / (0.0 + added.inertia()), 2.0 * 9.81, 1e-12);
}

// In liquid that accelerates as a whole a neutral sphere goes with it and a bubble accelerates three times as fast
// (Batchelor 1967, § 6.8). The pressure gradient pushes with ρ V Du/Dt.
TEST(AddedMass, InAcceleratingLiquid) {
  const AddedMass added{lone_sphere_added_mass, density, volume};
  const dem::Vec3 liquid{1.0, -2.0, 3.0};
  const dem::Vec3 force = density * volume * liquid + added.force_of_liquid(liquid);
  const auto acceleration = [&](double mass) { return 1.0 / (mass + added.inertia()) * force; };
  EXPECT_NEAR(acceleration(density * volume).y, liquid.y, 1e-12);
  EXPECT_NEAR(acceleration(0.0).x, 3.0 * liquid.x, 1e-12);
  EXPECT_NEAR(acceleration(0.0).z, 3.0 * liquid.z, 1e-12);
}

// The kinetic energy of the liquid between a sphere of radius a that moves with 1 and a shell of radius b at rest is
// ½ C_m ρ V: φ = (A r + B/r²) cos θ, with φ' = 1 at a and 0 at b, integrated over the gap.
TEST(AddedMass, ZuberIsTheEnergyOfTheLiquidInAShell) {
  for (const double voidage : {0.3, 0.5, 0.9, 0.999}) {
    const double a = 1.0, b = std::cbrt(1.0 / (1.0 - voidage));
    // A − 2B/a³ = 1, A − 2B/b³ = 0.
    const double dipole = 0.5 / (1.0 / (b * b * b) - 1.0 / (a * a * a)), uniform = 2.0 * dipole / (b * b * b);
    const auto energy = [&](double r) {
      const double radial = uniform - 2.0 * dipole / (r * r * r), along = uniform + dipole / (r * r * r);
      // Means of cos² and sin² over the sphere: 1/3 and 2/3.
      return 0.5 * 4.0 * std::numbers::pi * r * r * (radial * radial + 2.0 * along * along) / 3.0;
    };
    const std::function<double(double)> integrand = energy;
    gsl_function f{[](double r, void* p) { return (*static_cast<const std::function<double(double)>*>(p))(r); },
                   const_cast<std::function<double(double)>*>(&integrand)};
    double sum = 0.0, error = 0.0;
    std::size_t evaluations = 0;
    gsl_integration_qng(&f, a, b, 1e-10, 1e-9, &sum, &error, &evaluations);
    EXPECT_NEAR(zuber_added_mass(voidage), sum / (0.5 * 4.0 / 3.0 * std::numbers::pi), 1e-6) << voidage;
  }
  EXPECT_DOUBLE_EQ(zuber_added_mass(1.0), lone_sphere_added_mass);
}

}  // namespace
}  // namespace slfb::coupling
