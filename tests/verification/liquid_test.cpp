// The liquid alone and the exchange with spheres: geometry, conservation, pressure drop of a bed at rest, stability.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "correlations/drag/drag_laws.hpp"
#include "solver/coupling/phase_coupling.hpp"
#include "solver/fluid/liquid_solver.hpp"

namespace slfb {
namespace {

Scene water_column(double velocity) {
  Scene scene;
  scene.geometry.diameter = 0.05;
  scene.geometry.height = 0.15;
  scene.liquid = {998.2, 1e-3, velocity};
  scene.fluid.cells_across = 8;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.fluid.pressure_tolerance = 1e-12;
  scene.contact.stiffness = 1e4;
  scene.contact.time_step = 5e-5;
  scene.outlet.rule = OutletRule::remove;
  return scene;
}

TEST(ColumnGrid, HasTheExactSectionAtAnyResolution) {
  for (int cells : {1, 2, 3, 5, 8, 13, 40}) {
    Scene scene = water_column(0.1);
    scene.fluid.cells_across = cells;
    scene.fluid.cell_height = 0.05;
    const fluid::ColumnGrid grid(scene);
    const double area = std::accumulate(grid.areas().begin(), grid.areas().end(), 0.0);
    EXPECT_NEAR(area, std::numbers::pi * 0.025 * 0.025, 1e-12 * area) << cells;
    const double square = std::pow(0.05 / cells, 2);
    for (int c = 0; cells > 2 && c < grid.cells(); ++c) {
      EXPECT_GE(grid.area(c), 0.49 * square) << cells;
    }
  }
}

// Area of a quarter disc, a half disc and a circular segment against their closed forms.
TEST(ColumnGrid, CutsSquaresExactly) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(fluid::circle_rectangle_area(1, 0, 2, 0, 2), pi / 4, 1e-14);
  EXPECT_NEAR(fluid::circle_rectangle_area(1, -2, 2, -2, 0), pi / 2, 1e-14);
  EXPECT_NEAR(fluid::circle_rectangle_area(1, 0.5, 2, -2, 2), std::acos(0.5) - 0.5 * std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(fluid::circle_rectangle_area(1, -0.5, 0.5, -0.5, 0.5), 1.0, 1e-14);
}

fluid::Exchange no_exchange(const fluid::LiquidSolver& liquid) {
  fluid::Exchange exchange;
  for (std::size_t a = 0; a < 3; ++a) {
    exchange.coefficient[a].assign(liquid.nodes(a), 0.0);
    exchange.source[a].assign(liquid.nodes(a), 0.0);
  }
  return exchange;
}

std::vector<double> cell_volumes(const fluid::ColumnGrid& grid) {
  std::vector<double> volumes(grid.size());
  for (std::size_t c = 0; c < volumes.size(); ++c)
    volumes[c] = grid.volume(static_cast<int>(c / static_cast<std::size_t>(grid.layers())));
  return volumes;
}

double flow_through(const fluid::LiquidSolver& liquid, const std::vector<double>& volume, int level) {
  const auto& grid = liquid.grid();
  std::vector<double> nodes, full;
  liquid.scatter(2, volume, nodes);
  liquid.scatter(2, cell_volumes(grid), full);
  double sum = 0.0;
  for (int c = 0; c < grid.cells(); ++c) {
    const auto n = static_cast<std::size_t>(c * (grid.layers() + 1) + level);
    sum += nodes[n] / full[n] * grid.area(c) * liquid.velocity(2)[n];
  }
  return sum;
}

// Laminar pipe flow: the profile tends to 2 U (1 − r²/R²) with Δp/L = 32 μ U/D² (Hagen, Poiseuille).
TEST(Liquid, DevelopsPoiseuilleFlow) {
  Scene scene = water_column(0.01);
  scene.liquid.viscosity = 0.1;  // Re = 5: fully developed within one diameter
  scene.fluid.cells_across = 16;
  scene.fluid.cell_height = 0.0125;
  scene.fluid.time_step = 2e-3;
  fluid::LiquidSolver liquid(scene);
  const auto volume = cell_volumes(liquid.grid());
  const auto exchange = no_exchange(liquid);
  for (int k = 0; k < 800; ++k) liquid.advance(scene.fluid.time_step, volume, volume, exchange);
  double fastest = 0.0;
  for (double w : liquid.velocity(2)) fastest = std::max(fastest, w);
  EXPECT_NEAR(fastest, 0.02, 0.05 * 0.02);
  const int layers = liquid.grid().layers();
  const auto section_pressure = [&](int k) {
    double sum = 0.0;
    for (int c = 0; c < liquid.grid().cells(); ++c)
      sum += liquid.grid().area(c) * liquid.pressure()[static_cast<std::size_t>(c * layers + k)];
    return sum / liquid.grid().section_area();
  };
  const double gradient =
      (section_pressure(layers - 5) - section_pressure(layers - 2)) / (3 * liquid.grid().cell_height());
  EXPECT_NEAR(gradient, 32 * 0.1 * 0.01 / (0.05 * 0.05), 0.08 * 12.8);
}

// Whatever the spheres do, what flows in plus what they displace flows out, in every layer.
TEST(Liquid, ConservesVolumeUnderMovingSpheres) {
  Scene scene = water_column(0.06);
  fluid::LiquidSolver liquid(scene);
  const auto full = cell_volumes(liquid.grid());
  auto before = full, now = full;
  const auto exchange = no_exchange(liquid);
  for (std::size_t c = 0; c < full.size(); ++c) {
    before[c] *= 0.5 + 0.2 * std::sin(0.37 * static_cast<double>(c));
    now[c] *= 0.5 + 0.2 * std::sin(0.37 * static_cast<double>(c) + 0.01);
  }
  liquid.advance(scene.fluid.time_step, before, now, exchange);
  const double inflow = 0.06 * liquid.grid().section_area();
  EXPECT_LT(liquid.continuity_error(), 1e-9);
  const int layers = liquid.grid().layers();
  double displaced = 0.0;
  for (int k = 1; k <= layers; ++k) {
    for (int c = 0; c < liquid.grid().cells(); ++c) {
      const auto cell = static_cast<std::size_t>(c * layers + k - 1);
      displaced += (before[cell] - now[cell]) / scene.fluid.time_step;
    }
    EXPECT_NEAR(flow_through(liquid, now, k), inflow + displaced, 1e-8 * inflow) << k;
  }
}

/// Spheres on a cubic lattice in the column.
dem::Engine lattice(const Scene& scene, double spacing, double density) {
  dem::Engine engine(scene.contact, {}, {0, 0, 0}, 1);
  for (double z = 0.0025; z < scene.geometry.height - 0.0025; z += spacing)
    for (double y = -0.025; y < 0.025; y += spacing)
      for (double x = -0.025; x < 0.025; x += spacing)
        if (std::hypot(x, y) < 0.0225) engine.add_particle({x, y, z}, 0.0025, density, 0);
  return engine;
}

// Newton's third law over one step: the impulse on the spheres is what the liquid lost.
// The spheres' side is summed over spheres, the liquid's over its momentum nodes.
TEST(Coupling, WhatTheSpheresGainTheLiquidLoses) {
  Scene scene = water_column(0.06);
  fluid::LiquidSolver liquid(scene);
  dem::Engine engine = lattice(scene, 0.0061, 2230);
  for (std::size_t i = 0; i < engine.particles.size(); ++i) {
    engine.particles.velocity.x[i] = 0.02 * std::sin(static_cast<double>(i));
    engine.particles.velocity.z[i] = 0.05 * std::cos(3.0 * static_cast<double>(i));
  }
  coupling::PhaseCoupling exchange(scene, &liquid, 0.0025);
  exchange.advance(engine, scene.fluid.time_step);
  for (std::size_t a : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    double on_spheres = 0.0, magnitude = 0.0;
    for (std::size_t i = 0; i < engine.particles.size(); ++i) {
      on_spheres += exchange.drag_force(i, a);
      magnitude += std::abs(exchange.drag_force(i, a));
    }
    EXPECT_NEAR(on_spheres, exchange.drag_taken_from_liquid(a), 1e-12 * magnitude) << a;
  }
}

// A uniform frozen bed with frictionless walls has the pressure drop that the law alone gives, for every law.
TEST(Coupling, FrozenUniformBedHasTheLawsPressureDrop) {
  for (const char* name : {"ergun-1952", "wen-yu-1966", "di-felice-1994", "gibilaro-1985", "beetstra-2007"}) {
    Scene scene = water_column(0.05);
    scene.fluid.tier = FluidTier::one_dimensional;
    scene.coupling.drag_law = name;
    fluid::LiquidSolver liquid(scene);
    const auto& grid = liquid.grid();
    // Uniform voidage by construction: every cell gives the liquid the same share, drag by the law.
    const double voidage = 0.45, d = 0.005;
    std::vector<double> volume = cell_volumes(grid);
    for (double& v : volume) v *= voidage;
    auto frozen = no_exchange(liquid);
    const double reynolds = 998.2 * d * 0.05 / 1e-3;
    const double beta = drag::with_drag_law(name, [&](auto law) {
      return drag::exchange_coefficient(law({voidage, reynolds}), voidage, d, 1e-3);
    });
    std::vector<double> coefficient(grid.size());
    for (std::size_t c = 0; c < coefficient.size(); ++c) coefficient[c] = beta * volume[c] / voidage;
    liquid.scatter(2, coefficient, frozen.coefficient[2]);
    for (int k = 0; k < 50; ++k) liquid.advance(scene.fluid.time_step, volume, volume, frozen);
    // ε ∂p/∂z = −β U/ε for liquid at rest in acceleration.
    const double expected = beta * 0.05 / (voidage * voidage) * grid.column_height();
    EXPECT_NEAR(liquid.inlet_pressure(), expected, 1e-3 * expected) << name;
  }
}

// Semi-implicit drag (Eq. 35) stays bounded at any stiffness: 10 µm spheres, βΔt/ρ up to 1e3 and beyond.
TEST(Coupling, StaysStableAtStiffDrag) {
  Scene scene = water_column(0.0);
  scene.fluid.tier = FluidTier::quiescent;
  scene.fluid.time_step = 1e-2;
  dem::Engine engine(scene.contact, {}, {0, 0, 0}, 1);
  engine.add_particle({0, 0, 0.05}, 5e-6, 2230, 0);
  engine.particles.velocity.z[0] = 0.1;
  coupling::PhaseCoupling exchange(scene, nullptr, 5e-6);
  for (int k = 0; k < 5; ++k) {
    exchange.advance(engine, scene.fluid.time_step);
    engine.advance(200);
  }
  // Stokes: (ρ_p − ρ) g d²/(18 μ) = 6.7e-5 m/s.
  EXPECT_NEAR(engine.particles.velocity.z[0], -(2230 - 998.2) * gravity * 1e-10 / 18e-3, 1e-6);
}

// A sphere falling in still liquid ends at its terminal velocity: 6 mm steel in water, 1.1024 m/s with C_D = 0.44.
TEST(Coupling, SettlesAtTheTerminalVelocity) {
  Scene scene = water_column(0.0);
  scene.coupling.drag_law = "wen-yu-1966";
  scene.fluid.tier = FluidTier::quiescent;
  dem::Engine engine(scene.contact, {}, {0, 0, 0}, 1);
  engine.add_particle({0, 0, 0}, 0.003, 7800, 0);
  coupling::PhaseCoupling exchange(scene, nullptr, 0.003);
  for (int k = 0; k < 1500; ++k) {
    exchange.advance(engine, scene.fluid.time_step);
    engine.advance(20);
  }
  EXPECT_NEAR(engine.particles.velocity.z[0], -1.1024, 1e-3 * 1.1024);
}

}  // namespace
}  // namespace slfb
