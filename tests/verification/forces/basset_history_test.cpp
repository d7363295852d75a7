// History force against exact integrals and the exact motion of a sphere released in Stokes flow.
#include "solver/coupling/forces/basset_history.hpp"

#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/verification/forces/vectors.hpp"

namespace slfb::coupling {
namespace {

using Slip = std::function<Vec3(double)>;

/// The bracket ∫ w'/√(t − τ) dτ + w(0)/√t after `steps` steps.
Vec3 integral(const Slip& slip, double time_step, int steps, std::size_t window = 16) {
  BassetHistory history(time_step, window);
  history.add(slip(0.0));
  for (int k = 1; k < steps; ++k) {
    history.advance(0, slip(k * time_step));
    history.end_step();
  }
  return history.memory(0) + history.weight() * slip(steps * time_step);
}

double integrate(std::function<double(double)> f, double lower, double upper) {
  gsl_function function{[](double x, void* p) { return (*static_cast<std::function<double(double)>*>(p))(x); }, &f};
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(2000);
  double result = 0.0, error = 0.0;
  gsl_integration_qag(&function, lower, upper, 1e-12, 1e-10, 2000, GSL_INTEG_GAUSS61, workspace, &result, &error);
  gsl_integration_workspace_free(workspace);
  return result;
}

// w = c t: 2 c √t, exact while all is in the window, and within 0.2 % of the tail's part of it after that.
TEST(BassetHistory, OfASteadilyGrowingSlip) {
  const Slip slip = [](double t) { return t * Vec3{1.0, -2.0, 0.5}; };
  for (const int steps : {1, 5, 16}) {
    const double exact = 2.0 * std::sqrt(steps * 0.01);
    expect_near(integral(slip, 0.01, steps), exact * Vec3{1.0, -2.0, 0.5}, 1e-12);
  }
  for (const int steps : {40, 1000, 100000}) {
    const double exact = 2.0 * std::sqrt(steps * 0.01);
    expect_near(integral(slip, 0.01, steps), exact * Vec3{1.0, -2.0, 0.5}, 2e-3 * exact);
  }
}

// A slip that is there from the beginning and does not change: w/√t for all time.
TEST(BassetHistory, OfASlipFromTheBeginning) {
  const Slip slip = [](double) { return Vec3{0.3, 0.0, -0.1}; };
  for (const int steps : {1, 7, 30, 2000})
    expect_near(integral(slip, 0.01, steps), 1.0 / std::sqrt(steps * 0.01) * Vec3{0.3, 0.0, -0.1}, 1e-12);
}

// w = sin t: with x² = t − τ the integral is 2 ∫_0^√t cos(t − x²) dx. The error ends at that of the tail.
TEST(BassetHistory, OfAnOscillatingSlip) {
  const Slip slip = [](double t) { return Vec3{std::sin(t), 0.0, 0.0}; };
  const double time = 20.0;
  const double exact = 2.0 * integrate([&](double x) { return std::cos(time - x * x); }, 0.0, std::sqrt(time));
  const auto error = [&](int steps, std::size_t window) {
    return std::abs(integral(slip, time / steps, steps, window).x - exact);
  };
  EXPECT_LT(error(200, 16), 1.5e-2);
  EXPECT_LT(error(4000, 16), 5e-4);
  // With everything in the window only the piecewise linear slip errs, as Δt^1.5: by 8 per factor 4.
  EXPECT_NEAR(error(400, 400) / error(1600, 1600), 8.0, 1.0);
  EXPECT_LT(error(1600, 1600), 6e-4);
}

TEST(BassetHistory, ExponentialsStandForTheRoot) {
  const BassetHistory history(1e-3, 16);
  for (double windows = 1.0; windows <= 1e4; windows *= 1.1)
    EXPECT_NEAR(history.tail_kernel(windows * 16e-3) * std::sqrt(windows * 16e-3), 1.0, 2e-3) << windows;
}

/// Speed over terminal speed of a sphere released in Stokes flow, time in (m + ½ ρ V)/(3 π μ d):
/// u' = 1 − u − (B/√π) ∫ u'/√(T − s) ds, B = √(9 ρ/(2 ρ_p + ρ)). Its Laplace transform 1/(s (s + B √s + 1)) has no pole
/// beside 0, so u = 1 − (2 B/π) ∫_0^∞ e^(−x² T)/((1 − x²)² + B² x²) dx along the cut.
double released(double b, double time) {
  const auto f = [=](double x) { return std::exp(-x * x * time) / (std::pow(1.0 - x * x, 2) + b * b * x * x); };
  return 1.0 - 2.0 * b / std::numbers::pi * (integrate(f, 0.0, 2.0) + integrate(f, 2.0, 60.0));
}

// Glass in a viscous liquid, falling from rest by drag, added mass and history force, implicit in all three.
TEST(BassetHistory, ASphereReleasedInStokesFlow) {
  const LiquidProperties liquid{1000.0, 1.0};
  const double diameter = 2e-3, density = 2500.0, volume = std::numbers::pi / 6.0 * std::pow(diameter, 3);
  const double inertia = (density + 0.5 * liquid.density) * volume;
  const double drag = 3.0 * std::numbers::pi * liquid.viscosity * diameter, weight = 1500.0 * volume * 9.81;
  const double response = inertia / drag, history_factor = basset_coefficient(diameter, liquid);
  const auto largest_error = [&](int steps_per_response) {
    const double time_step = response / steps_per_response;
    BassetHistory history(time_step);
    history.add({});
    double velocity = 0.0, rate = weight / inertia, error = 0.0;
    for (int k = 1; k <= 20 * steps_per_response; ++k) {
      // Trapezoidal: the slip is −v; all forces at the end are linear in v.
      const double memory = history_factor * history.memory(0).z, stiff = drag + history_factor * history.weight();
      velocity = (velocity + 0.5 * time_step * (rate + (weight + memory) / inertia)) /
                 (1.0 + 0.5 * time_step * stiff / inertia);
      rate = (weight + memory - stiff * velocity) / inertia;
      history.advance(0, {0.0, 0.0, -velocity});
      history.end_step();
      const double exact = released(std::sqrt(9.0 / 6.0), k / static_cast<double>(steps_per_response));
      error = std::max(error, std::abs(velocity * drag / weight - exact));
    }
    return error;
  };
  const double coarse = largest_error(10), fine = largest_error(40);
  EXPECT_LT(coarse, 0.02);
  EXPECT_GT(coarse / fine, 4.0);  // at least first order
  EXPECT_LT(largest_error(200), 5e-4);
}

// Basset's coefficient by the force on a sphere that starts with constant velocity: Stokes' drag times
// 1 + r/√(π ν t) (Landau & Lifshitz, § 24, problem 7, without the added mass of the start).
TEST(BassetHistory, CoefficientOfAStartAtConstantVelocity) {
  const LiquidProperties liquid{900.0, 0.02};
  const double diameter = 3e-3, time = 0.05, nu = liquid.viscosity / liquid.density;
  const double force = basset_coefficient(diameter, liquid) * integral(
                                                                  [](double) {
                                                                    return Vec3{1, 0, 0};
                                                                  },
                                                                  time / 10, 10)
                                                                  .x;
  const double stokes = 3.0 * std::numbers::pi * liquid.viscosity * diameter;
  EXPECT_NEAR(force, stokes * 0.5 * diameter / std::sqrt(std::numbers::pi * nu * time), 1e-9 * force);
}

// Interrupted and resumed it goes on bit by bit; a sphere taken out leaves the others alone.
TEST(BassetHistory, ResumesAndLosesASphere) {
  BassetHistory whole(0.01, 8), resumed(0.01, 8), alone(0.01, 8);
  const auto slip = [](int i, int k) { return Vec3{std::sin(0.3 * k + i), std::cos(0.2 * k), 0.1 * k * i}; };
  whole.add(slip(0, 0));
  whole.add(slip(1, 0));
  alone.add(slip(1, 0));
  const auto step = [&](BassetHistory& history, int k, int first) {
    for (std::size_t i = 0; i < history.size(); ++i) history.advance(i, slip(static_cast<int>(i) + first, k));
    history.end_step();
  };
  for (int k = 1; k < 40; ++k) {
    step(whole, k, 0);
    step(alone, k, 1);
  }
  resumed.restore(whole.state());
  for (int k = 40; k < 70; ++k) {
    step(whole, k, 0);
    step(resumed, k, 0);
    step(alone, k, 1);
  }
  EXPECT_EQ(whole.memory(1).x, resumed.memory(1).x);
  whole.remove(0);
  EXPECT_EQ(whole.memory(0).x, alone.memory(0).x);
  EXPECT_EQ(whole.memory(0).z, alone.memory(0).z);
  EXPECT_THROW(BassetHistory(0.01, 9).restore(whole.state()), std::invalid_argument);
}

}  // namespace
}  // namespace slfb::coupling
