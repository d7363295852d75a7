// The liquid alone and the exchange with spheres: geometry, conservation, pressure drop of a bed at rest, stability.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/materials.hpp"
#include "solver/coupling/phase_coupling.hpp"
#include "solver/fluid/one_dimensional_liquid.hpp"
#include "solver/fluid/prescribed_liquid.hpp"
#include "solver/fluid/three_dimensional_liquid.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/user_law.hpp"
#include "tests/verification/liquid_cases.hpp"

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
  scene.species = {{"glass", 0.005, 2230, 1}};
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
    double moment = 0.0;
    for (int c = 0; c < grid.cells(); ++c) {
      if (cells > 2) {
        EXPECT_GE(grid.area(c), 0.49 * square) << cells;
      }
      EXPECT_LT(std::hypot(grid.centre(c)[0], grid.centre(c)[1]), 0.025) << cells;
      if (grid.centre(c)[0] > 1e-9) moment += grid.area(c) * grid.centroid(c)[0];
    }
    // First moment of the half disc: ⅔ R³.
    if (cells % 2 == 0) {
      EXPECT_NEAR(moment, 2.0 / 3.0 * std::pow(0.025, 3), 1e-12) << cells;
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

double flow_through(const fluid::StaggeredLiquid& liquid, const std::vector<double>& volume, int level) {
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
TEST(Liquid, TendsToPoiseuilleFlowInSecondOrder) {
  std::array<double, 2> profile_error{}, gradient_error{};
  for (std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    Scene scene;
    scene.geometry.diameter = 1.0;
    scene.geometry.height = 4.0;  // Re = 1: fully developed within one diameter
    scene.liquid = {1.0, 1.0, 1.0};
    scene.fluid.cells_across = i == 0 ? 12 : 24;
    scene.fluid.cell_height = 0.5;
    scene.fluid.pressure_tolerance = 1e-8;
    fluid::ThreeDimensionalLiquid liquid(scene);
    const auto& grid = liquid.grid();
    const auto volume = cell_volumes(grid);
    const auto exchange = no_exchange(liquid);
    for (int k = 0; k < 60; ++k) liquid.advance(0.01, volume, volume, exchange);
    const auto layers = static_cast<std::size_t>(grid.layers());
    double drop = 0.0;
    for (int c = 0; c < grid.cells(); ++c) {
      const auto cell = static_cast<std::size_t>(c);
      const auto at = grid.centroid(c);
      const double exact = 2.0 * (1.0 - 4.0 * (at[0] * at[0] + at[1] * at[1]));
      const double error = liquid.velocity(2)[cell * (layers + 1) + layers - 2] - exact;
      profile_error[i] += grid.area(c) * error * error;
      drop += grid.area(c) *
              (liquid.pressure()[cell * layers + layers - 3] - liquid.pressure()[cell * layers + layers - 2]);
    }
    gradient_error[i] = std::abs(drop / grid.section_area() / grid.cell_height() / 32.0 - 1.0);
    profile_error[i] = std::sqrt(profile_error[i] / grid.section_area());
  }
  EXPECT_LT(profile_error[1], 0.003);
  EXPECT_LT(gradient_error[1], 0.003);
  EXPECT_GE(order(profile_error[0], profile_error[1], 12, 24), 1.8);
  EXPECT_GE(order(gradient_error[0], gradient_error[1], 12, 24), 1.8);
}

// Nothing holds plug flow back in a frictionless column, however the wall cuts the cells.
TEST(Liquid, PassesASlipWallAsAPlug) {
  Scene scene = water_column(0.1);
  scene.fluid.wall = LateralBoundary::slip;
  scene.liquid.viscosity = 0.1;
  fluid::ThreeDimensionalLiquid liquid(scene);
  const auto volume = cell_volumes(liquid.grid());
  const auto exchange = no_exchange(liquid);
  for (int k = 0; k < 20; ++k) liquid.advance(scene.fluid.time_step, volume, volume, exchange);
  for (double w : liquid.velocity(2)) EXPECT_NEAR(w, 0.1, 1e-9);
  EXPECT_NEAR(liquid.inlet_pressure(), 0.0, 1e-6);
}

// Whatever the spheres do, what flows in plus what they displace flows out, in every layer and every step, to the
// tolerance of the pressure equation.
TEST(Liquid, ConservesVolumeUnderMovingSpheres) {
  for (const TimeScheme scheme : {TimeScheme::euler, TimeScheme::second_order}) {
    Scene scene = water_column(0.06);
    scene.fluid.time_scheme = scheme;
    fluid::ThreeDimensionalLiquid liquid(scene);
    const auto exchange = no_exchange(liquid);
    const auto volume_at = [&](int step) {
      auto volume = cell_volumes(liquid.grid());
      for (std::size_t c = 0; c < volume.size(); ++c)
        volume[c] *= 0.5 + 0.2 * std::sin(0.37 * static_cast<double>(c) + 0.01 * step * step);
      return volume;
    };
    const double inflow = 0.06 * liquid.grid().section_area();
    const int layers = liquid.grid().layers();
    for (int step = 1; step <= 10; ++step) {
      const auto now = volume_at(step), before = volume_at(step - 1), earlier = volume_at(step - 2);
      liquid.advance(scene.fluid.time_step, before, now, exchange);
      EXPECT_LT(liquid.continuity_error(), 1e-9);
      // The second-order difference starts with the second step.
      const bool backwards = scheme == TimeScheme::second_order && step > 1;
      double displaced = 0.0;
      for (int k = 1; k <= layers; ++k) {
        for (int c = 0; c < liquid.grid().cells(); ++c) {
          const auto cell = static_cast<std::size_t>(c * layers + k - 1);
          const double change =
              backwards ? 1.5 * now[cell] - 2.0 * before[cell] + 0.5 * earlier[cell] : now[cell] - before[cell];
          displaced -= change / scene.fluid.time_step;
        }
        EXPECT_NEAR(flow_through(liquid, now, k), inflow + displaced, 1e-8 * inflow) << step << ", " << k;
      }
    }
  }
}

// In one dimension α u + α_S v = U_L holds exactly at every height, here for a bed that moves up through the column
// with the velocity v.
TEST(Liquid, BalancesTheColumnExactly) {
  Scene scene = water_column(0.1);
  scene.fluid.tier = FluidTier::one_dimensional;
  scene.fluid.cell_height = 0.005;
  fluid::OneDimensionalLiquid liquid(scene);
  const auto& grid = liquid.grid();
  const double speed = 0.07, wave = 60.0, h = grid.cell_height();
  // Solids below a height at a time, per section area: ∫ 0.4 + 0.2 sin(wave (z − v t)) dz.
  const auto below = [&](double z, double t) {
    return 0.4 * z - 0.2 / wave * std::cos(wave * (z - speed * t)) + 0.2 / wave * std::cos(wave * speed * t);
  };
  const auto liquid_at = [&](double t) {
    auto volume = cell_volumes(grid);
    for (std::size_t k = 0; k < volume.size(); ++k)
      volume[k] -=
          grid.section_area() * (below(static_cast<double>(k + 1) * h, t) - below(static_cast<double>(k) * h, t));
    return volume;
  };
  const auto exchange = no_exchange(liquid);
  const double step = scene.fluid.time_step;
  for (int n = 0; n < 20; ++n) liquid.advance(step, liquid_at(n * step), liquid_at((n + 1) * step), exchange);
  const auto now = liquid_at(20 * step);
  for (int k = 1; k <= grid.layers(); ++k) {
    // What the spheres below the height have lost in the step went up through it.
    const double z = k * h, risen = (below(z, 19 * step) - below(z, 20 * step)) / step;
    EXPECT_NEAR(flow_through(liquid, now, k) / grid.section_area() + risen, 0.1, 1e-14) << z;
  }
}

// Without friction the pressure falls as the liquid gains speed: p + ½ ρ w² is constant (Bernoulli) where α falls.
TEST(Liquid, ColumnKeepsBernoullisSum) {
  Scene scene = water_column(0.2);
  scene.fluid.tier = FluidTier::one_dimensional;
  scene.fluid.convection = ConvectionScheme::central;
  scene.fluid.cell_height = scene.geometry.height / 200;
  scene.liquid.viscosity = 1e-9;
  fluid::OneDimensionalLiquid liquid(scene);
  const double height = scene.geometry.height;
  const auto void_fraction = [&](double z) { return 0.7 + 0.3 * std::cos(std::numbers::pi * z / height); };
  const auto volume = liquid_volumes(liquid.grid(), [&](const Point& x) { return void_fraction(x[2]); });
  const auto exchange = no_exchange(liquid);
  for (int k = 0; k < 2; ++k) liquid.advance(scene.fluid.time_step, volume, volume, exchange);
  const double fast = 0.2 / 0.4, slow = 0.2 / 1.0;
  const double expected = 0.5 * scene.liquid.density * (fast * fast - slow * slow);
  EXPECT_NEAR(liquid.inlet_pressure(), expected, 0.01 * expected);
}

/// A column of a few cells with spheres at rest in it, unevenly spread.
struct SmallBed {
  explicit SmallBed(TimeScheme scheme) {
    scene.fluid.cells_across = 4;
    scene.fluid.cell_height = scene.geometry.height / 4;
    scene.fluid.time_step = 5e-3;
    scene.fluid.pressure_tolerance = 1e-8;
    scene.fluid.time_scheme = scheme;
  }
  void fill(fluid::StaggeredLiquid& liquid) {
    volume = cell_volumes(liquid.grid());
    auto drag = volume;
    for (std::size_t c = 0; c < volume.size(); ++c) {
      const double solid = 0.4 + 0.1 * std::sin(1.7 * static_cast<double>(c));
      drag[c] *= 1e4 * solid;
      volume[c] *= 1.0 - solid;
    }
    exchange = no_exchange(liquid);
    for (std::size_t a = 0; a < 3; ++a) liquid.scatter(a, drag, exchange.coefficient[a]);
  }
  Scene scene = water_column(0.05);
  std::vector<double> volume;
  fluid::Exchange exchange;
};

TEST(Liquid, DoesNotDriftOverAHundredThousandSteps) {
  SmallBed bed(TimeScheme::euler);
  fluid::ThreeDimensionalLiquid liquid(bed.scene);
  bed.fill(liquid);
  const auto run = [&](int steps) {
    for (int k = 0; k < steps; ++k) liquid.advance(bed.scene.fluid.time_step, bed.volume, bed.volume, bed.exchange);
  };
  run(2000);
  const auto velocity = liquid.velocity(2);
  const double pressure = liquid.inlet_pressure();
  run(98000);
  for (std::size_t n = 0; n < velocity.size(); ++n) EXPECT_NEAR(liquid.velocity(2)[n], velocity[n], 1e-9);
  EXPECT_NEAR(liquid.inlet_pressure(), pressure, 1e-9 * pressure);
  EXPECT_LT(liquid.continuity_error(), 1e-9);
}

// SIMPLE and the projection, Euler and second order meet in the same steady flow.
TEST(Liquid, EverySchemeHasTheSameSteadyFlow) {
  std::vector<double> expected;
  for (const PressureVelocity method : {PressureVelocity::projection, PressureVelocity::simple})
    for (const TimeScheme scheme : {TimeScheme::euler, TimeScheme::second_order}) {
      SmallBed bed(scheme);
      bed.scene.fluid.pressure_velocity = method;
      fluid::ThreeDimensionalLiquid liquid(bed.scene);
      bed.fill(liquid);
      for (int k = 0; k < 1000; ++k) liquid.advance(bed.scene.fluid.time_step, bed.volume, bed.volume, bed.exchange);
      if (expected.empty()) expected = liquid.velocity(2);
      for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_NEAR(liquid.velocity(2)[n], expected[n], 1e-7);
    }
}

// What state() holds is all that the next step starts from.
TEST(Liquid, ContinuesFromItsStateBitByBit) {
  for (const TimeScheme scheme : {TimeScheme::euler, TimeScheme::second_order}) {
    SmallBed bed(scheme);
    fluid::ThreeDimensionalLiquid whole(bed.scene), second_half(bed.scene);
    bed.fill(whole);
    const auto full = cell_volumes(whole.grid());
    auto before = bed.volume;
    const auto step = [&](fluid::StaggeredLiquid& liquid, int k) {
      auto now = bed.volume;
      for (std::size_t c = 0; c < now.size(); ++c) now[c] += 0.01 * std::sin(0.1 * k) * full[c];
      liquid.advance(bed.scene.fluid.time_step, before, now, bed.exchange);
      before = std::move(now);
    };
    for (int k = 1; k <= 5; ++k) step(whole, k);
    second_half.restore(whole.state());
    const auto resumed_from = before;
    for (int k = 6; k <= 8; ++k) step(whole, k);
    before = resumed_from;
    for (int k = 6; k <= 8; ++k) step(second_half, k);
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(whole.velocity(a), second_half.velocity(a));
    EXPECT_EQ(whole.pressure(), second_half.pressure());
  }
}

// A section of a single cell needs no pressure equation, whatever the scene calls its tier.
TEST(LiquidTiers, ASingleCellOfTheThreeDimensionalTierIsTheOneDimensionalOne) {
  Scene scene = water_column(0.06);
  scene.fluid.cells_across = 1;
  const auto single_cell = fluid::make_liquid(scene);
  scene.fluid.tier = FluidTier::one_dimensional;
  fluid::OneDimensionalLiquid column(scene);
  const auto volume = liquid_volumes(column.grid(), [](const Point& x) { return 0.5 + 2.0 * x[2]; });
  const auto exchange = no_exchange(column);
  for (fluid::Liquid* liquid : {single_cell.get(), static_cast<fluid::Liquid*>(&column)})
    for (int k = 0; k < 3; ++k) liquid->advance(scene.fluid.time_step, volume, volume, exchange);
  EXPECT_EQ(single_cell->cost().pressure_iterations, 0);
  EXPECT_EQ(single_cell->pressure(), column.pressure());
  EXPECT_EQ(single_cell->state(), column.state());
}

// Of a liquid whose velocity is given every sphere feels the same, and gives nothing back.
TEST(LiquidTiers, APrescribedLiquidIsTheSameEverywhereAndTakesNothing) {
  Scene scene = water_column(0.05);
  scene.fluid.tier = FluidTier::quiescent;
  const auto liquid = fluid::make_liquid(scene);
  EXPECT_FALSE(liquid->two_way());
  dem::Engine engine = make_engine(scene.contact, {}, {0, 0, 0}, 1);
  engine.add_particle({0.0, 0.0, 0.01}, 0.0025, 2230, 0);
  engine.add_particle({0.02, -0.01, 0.14}, 0.0025, 2230, 0);
  coupling::PhaseCoupling exchange(scene, *liquid, find_drag_law(scene.coupling.drag_law));
  exchange.advance(engine, scene.fluid.time_step);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(exchange.voidage(i), 1.0);
    EXPECT_EQ(exchange.liquid_velocity(i, 2), 0.05);
    EXPECT_EQ(exchange.drag_force(i, 2), exchange.drag_force(0, 2));
    EXPECT_GT(exchange.drag_force(i, 2), 0.0);
  }
  EXPECT_EQ(exchange.drag_taken_from_liquid(2), 0.0);
  EXPECT_TRUE(exchange.void_fraction().empty());
}

/// Spheres on a cubic lattice in the column.
dem::Engine lattice(const Scene& scene, double spacing, double density) {
  dem::Engine engine = make_engine(scene.contact, {}, {0, 0, 0}, 1);
  for (double z = 0.0025; z < scene.geometry.height - 0.0025; z += spacing)
    for (double y = -0.025; y < 0.025; y += spacing)
      for (double x = -0.025; x < 0.025; x += spacing)
        if (std::hypot(x, y) < 0.0225) engine.add_particle({x, y, z}, 0.0025, density, 0);
  return engine;
}

// Newton's third law over one step: the impulse on the spheres is what the liquid lost.
// The spheres' side is summed over spheres, the liquid's over its momentum nodes.
TEST(Coupling, WhatTheSpheresGainTheLiquidLoses) {
  for (const bool times_voidage : {false, true}) {
    Scene scene = water_column(0.06);
    scene.coupling.drag_times_voidage = times_voidage;
    fluid::ThreeDimensionalLiquid liquid(scene);
    dem::Engine engine = lattice(scene, 0.0061, 2230);
    for (std::size_t i = 0; i < engine.particles.size(); ++i) {
      engine.particles.velocity.x[i] = 0.02 * std::sin(static_cast<double>(i));
      engine.particles.velocity.z[i] = 0.05 * std::cos(3.0 * static_cast<double>(i));
    }
    coupling::PhaseCoupling exchange(scene, liquid, find_drag_law(scene.coupling.drag_law));
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
}

// The steady flow through an empty column follows its inlet to another velocity, in every tier that solves for it.
TEST(Liquid, FollowsItsInlet) {
  for (const FluidTier tier : {FluidTier::one_dimensional, FluidTier::three_dimensional}) {
    Scene scene = water_column(0.05);
    scene.fluid.tier = tier;
    scene.fluid.wall = LateralBoundary::slip;
    const auto liquid = solved_liquid(scene);
    const auto volume = liquid_volumes(liquid->grid(), [](const Point&) { return 1.0; });
    const auto none = no_exchange(*liquid);
    for (int k = 0; k < 3; ++k) liquid->advance(scene.fluid.time_step, volume, volume, none);
    liquid->set_superficial_velocity(0.02);
    for (int k = 0; k < 3; ++k) liquid->advance(scene.fluid.time_step, volume, volume, none);
    const auto& velocity = liquid->velocity(2);
    const auto [slowest, fastest] = std::minmax_element(velocity.begin(), velocity.end());
    EXPECT_NEAR(*slowest, 0.02, 1e-6);
    EXPECT_NEAR(*fastest, 0.02, 1e-6);
  }
}

// A uniform frozen bed with frictionless walls has the pressure drop that the law alone gives, for every law: in one
// dimension and in the round column.
TEST(Coupling, FrozenUniformBedHasTheLawsPressureDrop) {
  const auto expect_drop = [](const auto& law) {
    for (const FluidTier tier : {FluidTier::one_dimensional, FluidTier::three_dimensional}) {
      Scene scene = water_column(0.05);
      scene.fluid.tier = tier;
      scene.fluid.wall = LateralBoundary::slip;
      const auto liquid_of_tier = solved_liquid(scene);
      fluid::StaggeredLiquid& liquid = *liquid_of_tier;
      const auto& grid = liquid.grid();
      // Uniform voidage by construction: every cell gives the liquid the same share, drag by the law.
      const double voidage = 0.45, d = 0.005, reynolds = 998.2 * d * 0.05 / 1e-3;
      const double beta = drag::exchange_coefficient(law({voidage, reynolds}), voidage, d, 1e-3);
      const auto volume = liquid_volumes(grid, [&](const Point&) { return voidage; });
      std::vector<double> coefficient = cell_volumes(grid);
      for (double& c : coefficient) c *= beta;
      auto frozen = no_exchange(liquid);
      for (std::size_t a = 0; a < 3; ++a) liquid.scatter(a, coefficient, frozen.coefficient[a]);
      // The drag is implicit in the pressure equation too: the first step brings the liquid to speed.
      for (int k = 0; k < 3; ++k) liquid.advance(scene.fluid.time_step, volume, volume, frozen);
      // ε ∂p/∂z = −β U/ε for liquid at rest in acceleration.
      const double expected = beta * 0.05 / (voidage * voidage) * grid.column_height();
      EXPECT_NEAR(liquid.inlet_pressure(), expected, 1e-3 * expected) << law.info.name;
    }
  };
  for_each_law<drag::DragLaws>(expect_drop);
}

// Semi-implicit drag (Eq. 35) stays bounded at any stiffness: 10 µm spheres, βΔt/ρ up to 1e3 and beyond.
TEST(Coupling, StaysStableAtStiffDrag) {
  Scene scene = water_column(0.0);
  scene.fluid.tier = FluidTier::quiescent;
  scene.fluid.time_step = 1e-2;
  dem::Engine engine = make_engine(scene.contact, {}, {0, 0, 0}, 1);
  engine.add_particle({0, 0, 0.05}, 5e-6, 2230, 0);
  engine.particles.velocity.z[0] = 0.1;
  fluid::PrescribedLiquid liquid(scene, 0.0);
  coupling::PhaseCoupling exchange(scene, liquid, find_drag_law(scene.coupling.drag_law));
  for (int k = 0; k < 5; ++k) {
    exchange.advance(engine, scene.fluid.time_step);
    engine.advance(200);
  }
  // Stokes: (ρ_p − ρ) g d²/(18 μ) = 6.7e-5 m/s.
  EXPECT_NEAR(engine.particles.velocity.z[0], -(2230 - 998.2) * gravitational_acceleration * 1e-10 / 18e-3, 1e-6);
}

// A sphere falling in still liquid ends at its terminal velocity: 6 mm steel in water, 1.1024 m/s with C_D = 0.44.
TEST(Coupling, SettlesAtTheTerminalVelocity) {
  Scene scene = water_column(0.0);
  scene.coupling.drag_law = "wen-yu-1966";
  scene.fluid.tier = FluidTier::quiescent;
  dem::Engine engine = make_engine(scene.contact, {}, {0, 0, 0}, 1);
  engine.add_particle({0, 0, 0}, 0.003, 7800, 0);
  fluid::PrescribedLiquid liquid(scene, 0.0);
  coupling::PhaseCoupling exchange(scene, liquid, find_drag_law(scene.coupling.drag_law));
  for (int k = 0; k < 1500; ++k) {
    exchange.advance(engine, scene.fluid.time_step);
    engine.advance(20);
  }
  EXPECT_NEAR(engine.particles.velocity.z[0], -1.1024, 1e-3 * 1.1024);
}

}  // namespace
}  // namespace slfb
