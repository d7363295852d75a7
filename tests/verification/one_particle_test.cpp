// The one-particle rung (SUNDIALS) against published terminal velocities, an exact solution, and the particle engine.
#include "solver/one_particle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/coupling/phase_coupling.hpp"

namespace slfb {
namespace {

OneParticleFall steel_in_water() {
  OneParticleFall fall;
  fall.diameter = 0.006;
  fall.density = 7800;
  fall.liquid_density = fall.surrounding_density = 998.2;
  fall.viscosity = 1e-3;
  fall.height = 1.0;
  return fall;
}

// C_D = 0.44: u = √(4 g d (ρ_p − ρ)/(3 C_D ρ)) = 1.1024 m/s.
TEST(OneParticleFall, ReachesTheTerminalVelocity) {
  const auto states = integrate_fall(steel_in_water(), {0.0, 0.5, 1.5, 3.0});
  EXPECT_NEAR(states.back().velocity, -1.1024, 2e-4);
}

// Constant C_D: v = u_t tanh(t g'/u_t), g' = g (1 − ρ/ρ_p). Above Re = 1000 the law is just that.
TEST(OneParticleFall, FollowsTheHyperbolicTangent) {
  OneParticleFall fall = steel_in_water();
  const double terminal = 1.1024, gravity_reduced = gravity * (1 - 998.2 / 7800);
  const double start = 0.25 * terminal / gravity_reduced;  // begin where Re > 1000
  fall.velocity = -terminal * std::tanh(0.25);
  const auto states = integrate_fall(fall, {start, start + 0.05, start + 0.2});
  for (const auto& state : states)
    EXPECT_NEAR(state.velocity, -terminal * std::tanh(state.time * gravity_reduced / terminal), 3e-4);
}

// The engine's drag, K at the old slip times the new slip (Eq. 35), is centred in v² where C_D is constant: second
// order.
TEST(OneParticleFall, EngineConvergesToIt) {
  const auto reference = integrate_fall(steel_in_water(), {0.0, 0.1}).back();
  const auto error = [&](double liquid_step) {
    Scene scene;
    scene.liquid = {998.2, 1e-3, 0.0};
    scene.fluid.tier = FluidTier::quiescent;
    scene.coupling.drag_law = "wen-yu-1966";
    scene.contact.stiffness = 1e4;
    scene.contact.time_step = 5e-5;
    dem::Engine engine(scene.contact, {}, {0, 0, 0}, 1);
    engine.add_particle({0, 0, 1.0}, 0.003, 7800, 0);
    coupling::PhaseCoupling exchange(scene, nullptr);
    for (int k = 0; k < std::lround(0.1 / liquid_step); ++k) {
      exchange.advance(engine, liquid_step);
      engine.advance(std::lround(liquid_step / 5e-5));
    }
    return std::abs(engine.particles.velocity.z[0] - reference.velocity);
  };
  EXPECT_LT(error(1e-3), 1e-5);
  EXPECT_GT(error(1e-2) / error(5e-3), 3.0);
}

}  // namespace
}  // namespace slfb
