// Lubrication inside the particle engine: a sphere that sinks onto a wall or another sphere through squeezed liquid.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "correlations/materials.hpp"
#include "few_spheres.hpp"
#include "solver/laws/make_engine.hpp"

namespace slfb::dem {
namespace {

constexpr double viscosity = 1.0, radius = 0.0025, roughness = 1e-6, range = 1e-4;

Contact contact_with(Integrator integrator) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.sliding_friction = 0.0;
  contact.time_step = 1e-6;
  contact.integrator = integrator;
  return contact;
}

// Heavy drag and a constant force G: the exact gap of m h'' = −G − c h' (1/h − 1/H) follows from its first integral,
// c (ln h − h/H) + m h' + G t = constant, which holds at every moment whatever the step has been.
TEST(LubricationInTheEngine, KeepsTheFirstIntegralOfASinkingSphere) {
  for (const bool at_wall : {true, false}) {
    const double coefficient = 6.0 * std::numbers::pi * viscosity * std::pow(at_wall ? radius : 0.5 * radius, 2);
    Engine engine = make_engine(contact_with(Integrator::symplectic_euler),
                                at_wall ? std::vector{floor_at_zero} : std::vector<Wall>{}, {0, 0, 0}, 1);
    engine.lubricate({viscosity, roughness, range});
    const double start = 5e-5;
    // Between two spheres the pair's reduced mass moves: equal and opposite forces on both.
    const double bottom = at_wall ? 0.0 : radius;
    if (!at_wall) engine.add_particle({0, 0, 0}, radius, 2230, 0);
    const std::size_t i = engine.add_particle({0, 0, bottom + radius + start}, radius, 2230, 0);
    const double mass = engine.particles.mass[i] * (at_wall ? 1.0 : 0.5), weight = 2e-3;
    engine.external_force.z[i] = -weight;
    if (!at_wall) engine.external_force.z[0] = weight;
    const auto gap = [&] {
      return engine.particles.position.z[i] - (at_wall ? 0.0 : engine.particles.position.z[0] + radius) - radius;
    };
    const auto integral = [&](double time) {
      const double speed = engine.particles.velocity.z[i] - (at_wall ? 0.0 : engine.particles.velocity.z[0]);
      return coefficient * (std::log(gap()) - gap() / range) + mass * speed + weight * time;
    };
    const double before = integral(0.0);
    for (int k = 1; k <= 20; ++k) {
      engine.advance(1000);
      const double time = 1e-3 * k;
      EXPECT_NEAR(integral(time), before, 2e-3 * weight * time + 1e-9) << at_wall << " " << time;
    }
    EXPECT_LT(gap(), 0.9 * start);
    EXPECT_GT(gap(), roughness);
  }
}

// The same spheres split between threads, bit by bit.
TEST(LubricationInTheEngine, IsTheSameAtAnyNumberOfThreads) {
  std::vector<double> reference;
  for (const int threads : {1, 2, 3}) {
    Engine engine = make_engine(contact_with(Integrator::symplectic_euler), {floor_at_zero}, {0, 0, 0}, threads);
    engine.lubricate({viscosity, roughness, range});
    for (int k = 0; k < 60; ++k) {
      const auto i = engine.add_particle({5.05e-3 * (k % 4), 5.04e-3 * (k / 4 % 4), 2.52e-3 + 5.03e-3 * (k / 16)},
                                         radius, 2230, 0);
      engine.particles.velocity.x[i] = 0.01 * std::sin(k);
      engine.particles.velocity.z[i] = 0.01 * std::cos(3 * k);
      engine.external_force.z[i] = -gravitational_acceleration * engine.particles.mass[i];
    }
    engine.advance(2000);
    if (threads == 1)
      reference = engine.particles.position.z;
    else
      EXPECT_EQ(engine.particles.position.z, reference) << threads;
  }
}

}  // namespace
}  // namespace slfb::dem
