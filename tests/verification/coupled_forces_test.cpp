// The forces that a scene can switch on, as the coupled code takes them: added mass, Basset's history, lift, torque.
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <numbers>

#include "correlations/materials.hpp"
#include "solver/coupling/forces/saffman_lift.hpp"
#include "solver/run/one_particle.hpp"
#include "solver/run/simulation.hpp"
#include "tests/verification/coupled_cases.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

Scene quiescent(double diameter, double density, LiquidProperties liquid) {
  Scene scene = periodic_box(0.05, 0.1, 4, 0.0);
  scene.liquid = {liquid.density, liquid.viscosity, 0.0};
  scene.fluid.tier = FluidTier::quiescent;
  scene.coupling.drag_law = "wen-yu-1966";
  scene.species = {{"sphere", diameter, density, 1}};
  return scene;
}

// Released at rest a sphere starts with (m − ρ V) g/(m + C ρ V), light ones upwards; alone or in a liquid on the grid.
TEST(AddedMass, SetsTheFirstAcceleration) {
  for (const FluidTier tier : {FluidTier::quiescent, FluidTier::three_dimensional})
    for (const double density : {7800.0, 1500.0, 500.0, 50.0})
      for (const double coefficient : {0.0, 0.5, 1.0}) {
        Scene scene = quiescent(0.005, density, {998.2, 1e-3});
        scene.fluid.tier = tier;
        scene.coupling.added_mass = coefficient;
        scene.fluid.time_step = scene.contact.time_step = 1e-7;
        CoupledCase bed(scene);
        bed.add({0.001, 0.002, 0.05});
        bed.step();
        const double expected = -(density - 998.2) * gravitational_acceleration / (density + coefficient * 998.2);
        EXPECT_NEAR(bed.engine.particles.velocity.z[0] / 1e-7, expected, 1e-5 * std::abs(expected))
            << density << ", " << coefficient;
      }
}

// The whole way to the terminal velocity is that of the same equation by CVODE, for a bubble-light sphere too, with
// which an added mass taken as a force from the last step would diverge. Semi-implicit drag: second order or 1e-3.
TEST(AddedMass, FollowsTheReferenceFall) {
  for (const double density : {7800.0, 1500.0, 50.0}) {
    Scene scene = quiescent(0.003, density, {998.2, 1e-3});
    scene.coupling.added_mass = 0.5;
    scene.fluid.time_step = scene.contact.time_step = 2e-4;
    CoupledCase bed(scene);
    bed.add({0.0, 0.0, 0.0});
    OneParticleFall fall;
    fall.diameter = 0.003;
    fall.density = density;
    fall.liquid_density = fall.surrounding_density = 998.2;
    fall.viscosity = 1e-3;
    fall.added_mass = 0.5;
    const std::vector<double> times{0.0, 0.02, 0.05, 0.1, 0.3};
    const auto reference = integrate_fall(fall, times);
    const double terminal = std::abs(reference.back().velocity);
    for (std::size_t k = 1; k < times.size(); ++k) {
      bed.run(times[k] - times[k - 1]);
      EXPECT_NEAR(bed.engine.particles.velocity.z[0], reference[k].velocity, 1e-3 * terminal)
          << density << ", " << times[k];
    }
  }
}

// What the sphere's added mass takes up the liquid has lost, a step later: the momentum of both and of what is under
// way is that of the forces from outside.
TEST(AddedMass, IsTakenFromTheLiquid) {
  Scene scene = periodic_box(0.03, 0.06, 5, 0.0);
  scene.coupling.added_mass = 0.5;
  CoupledCase bed(scene);
  bed.add({0.002, 0.001, 0.031}, {0.08, 0.0, 0.0});
  const double volume = bed.engine.particles.volume(0), mass = bed.engine.particles.mass[0];
  // Along x nothing from outside acts on a periodic box but the viscosity at its ends, which is off here.
  const auto momentum = [&] {
    std::vector<double> nodes;
    bed.liquid->scatter(0, bed.exchange->liquid_volume(), nodes);
    double sum = mass * bed.engine.particles.velocity.x[0];
    for (std::size_t n = 0; n < nodes.size(); ++n) sum += 998.2 * nodes[n] * bed.liquid->velocity(0)[n];
    return sum;
  };
  const double start = mass * 0.08;
  double before = 0.08;
  for (int k = 0; k < 30; ++k) {
    before = bed.engine.particles.velocity.x[0];
    bed.step();
  }
  const double under_way = 0.5 * 998.2 * volume * (bed.engine.particles.velocity.x[0] - before);
  // The rest: liquid that the sphere displaces moves against it, and leaves at the outlet.
  EXPECT_NEAR(momentum() + under_way, start, 0.01 * start);
  EXPECT_LT(mass * bed.engine.particles.velocity.x[0], 0.9 * start);
}

/// ∫ f over [from, to] by Simpson's rule.
template <class F>
double integrate(const F& f, double from, double to) {
  constexpr int pieces = 1000;
  const double h = (to - from) / pieces;
  double sum = f(from) + f(to);
  for (int k = 1; k < pieces; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * f(from + k * h);
  return sum * h / 3.0;
}

/// Speed over terminal speed of a sphere released in Stokes flow with added mass and history force, time in
/// (m + ½ ρ V)/(3 π μ d): 1 − (2 B/π) ∫_0^∞ e^(−x² T)/((1 − x²)² + B² x²) dx, B = √(9 ρ/(2 ρ_p + ρ)), by Laplace
/// transform along the cut.
double released(double b, double time) {
  const auto f = [=](double x) { return std::exp(-x * x * time) / (std::pow(1.0 - x * x, 2) + b * b * x * x); };
  return 1.0 - 2.0 * b / std::numbers::pi * (integrate(f, 0.0, 2.0) + integrate(f, 2.0, 60.0));
}

double largest_release_error(double density, int steps_per_response, bool history) {
  const double d = 1e-3, liquid = 1000.0, viscosity = 1e3;  // Re of 1e-8: Stokes' drag within 1e-6
  const double response = (density + 0.5 * liquid) * d * d / (18.0 * viscosity);
  const double terminal = (density - liquid) * gravitational_acceleration * d * d / (18.0 * viscosity);
  Scene scene = quiescent(d, density, {liquid, viscosity});
  scene.coupling.added_mass = 0.5;
  scene.coupling.basset_history = history;
  scene.fluid.time_step = scene.contact.time_step = response / steps_per_response;
  CoupledCase bed(scene);
  bed.add({0.0, 0.0, 0.0});
  double error = 0.0;
  const double b = std::sqrt(9.0 * liquid / (2.0 * density + liquid));
  for (int k = 1; k <= 10 * steps_per_response; ++k) {
    bed.step();
    const double exact = released(b, k / static_cast<double>(steps_per_response));
    error = std::max(error, std::abs(-bed.engine.particles.velocity.z[0] / terminal - exact));
  }
  return error;
}

// Glass and a sphere that is hardly heavier than the liquid, released: first order in the step, and the history force
// is what makes it right.
TEST(BassetForce, ReleaseFollowsTheExactStokesSolution) {
  for (const double density : {2500.0, 1100.0}) {
    const double coarse = largest_release_error(density, 20, true), fine = largest_release_error(density, 80, true);
    EXPECT_LT(coarse, 0.03) << density;
    EXPECT_GT(coarse / fine, 2.5) << density;
    EXPECT_LT(fine, 0.01) << density;
    EXPECT_GT(largest_release_error(density, 80, false), 0.15) << density;
  }
}

/// Lift on a sphere: what switching it on adds to its velocity over a short step, as a force.
Point lift_of(Scene scene, const std::array<Field, 3>& stream, const Point& place, const Point& velocity,
              const Point& spin, bool saffman) {
  scene.fluid.time_step = scene.contact.time_step = 1e-6;
  std::array<Point, 2> after{};
  double mass = 0.0;
  for (const bool on : {false, true}) {
    (saffman ? scene.coupling.saffman_lift : scene.coupling.magnus_lift) = on;
    CoupledCase bed(scene);
    bed.add(place, velocity, spin);
    mass = bed.engine.particles.mass[0];
    if (bed.liquid) {
      start_from(*bed.liquid, stream, [](const Point&) { return 0.0; });
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t s = 0; s < bed.liquid->end_velocity(a, 0).size(); ++s) {
          auto at = bed.liquid->position(a, s * (bed.liquid->nodes(a) / bed.liquid->end_velocity(a, 0).size()));
          at[2] = 0.0;
          bed.liquid->end_velocity(a, 0)[s] = stream[a](at);
        }
    }
    bed.step();
    after[on ? 1 : 0] = bed.engine.particles.velocity.at(0);
  }
  Point force{};
  for (std::size_t a = 0; a < 3; ++a) force[a] = mass * (after[1][a] - after[0][a]) / 1e-6;
  return force;
}

/// A box of still or sheared water with frictionless sides, small spheres in it.
Scene sheared_box() {
  Scene scene = periodic_box(0.02, 0.04, 10, 0.0);
  scene.fluid.wall = LateralBoundary::slip;
  scene.species = {{"sphere", 0.001, 1100.0, 1}};
  scene.coupling.drag_law = "wen-yu-1966";
  return scene;
}

const Field nothing = [](const Point&) { return 0.0; };

// Upward stream that is faster towards one side, whichever: a sphere that lags is driven there, one that leads away
// from there, with Saffman's and Mei's size of the known shear and slip.
TEST(SaffmanLiftInTheBed, PointsToTheFasterLiquidForASphereThatLags) {
  const double shear = 8.0;
  for (const double angle : {0.0, 0.5 * std::numbers::pi, std::numbers::pi, 0.6}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const std::array<Field, 3> stream{nothing, nothing, [=](const Point& x) { return shear * (c * x[0] + s * x[1]); }};
    for (const double lag : {0.03, -0.03}) {
      const Point force = lift_of(sheared_box(), stream, {0.001, 0.001, 0.021},
                                  {0.0, 0.0, shear * 0.001 * (c + s) - lag}, {0, 0, 0}, true);
      const LiquidProperties water{998.2, 1e-3};
      const double size = norm(coupling::mei_lift({0, 0, lag}, {0, shear, 0}, 0.001, water));
      const double sign = lag > 0.0 ? 1.0 : -1.0;
      EXPECT_NEAR(force[0], sign * c * size, 0.02 * size) << angle << ", " << lag;
      EXPECT_NEAR(force[1], sign * s * size, 0.02 * size) << angle << ", " << lag;
      EXPECT_NEAR(force[2], 0.0, 0.02 * size) << angle << ", " << lag;
    }
  }
}

// The same lying down: a stream along x or y, faster higher up, lifts or sinks a sphere along z.
TEST(SaffmanLiftInTheBed, ActsAlongZInAHorizontalShear) {
  const double shear = 8.0, height = 0.021;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
    for (const double lag : {0.03, -0.03}) {
      Scene scene = sheared_box();
      scene.fluid.wall = LateralBoundary::periodic;
      std::array<Field, 3> stream{nothing, nothing, nothing};
      stream[axis] = [=](const Point& x) { return shear * x[2]; };
      Point velocity{};
      velocity[axis] = shear * height - lag;
      const Point force = lift_of(scene, stream, {0.001, 0.001, height}, velocity, {0, 0, 0}, true);
      const double size = norm(coupling::mei_lift({0, 0, lag}, {0, shear, 0}, 0.001, {998.2, 1e-3}));
      EXPECT_NEAR(force[2], lag > 0.0 ? size : -size, 0.02 * size) << axis << ", " << lag;
      EXPECT_NEAR(force[0], 0.0, 0.02 * size);
      EXPECT_NEAR(force[1], 0.0, 0.02 * size);
    }
}

// A spinning sphere in still liquid is pushed along Ω × v (backspin lifts), obliquely as along the axes.
TEST(MagnusLiftInTheBed, PushesAlongSpinCrossVelocity) {
  const Scene scene = quiescent(0.001, 1100.0, {998.2, 1e-3});
  for (const auto& [spin, velocity] : {std::pair{Point{0, 0, 50}, Point{0.03, 0, 0}},
                                       {Point{50, 0, 0}, Point{0, 0.03, 0}},
                                       {Point{0, 50, 0}, Point{0, 0, -0.03}},
                                       {Point{20, -30, 25}, Point{0.02, 0.01, -0.02}}}) {
    const Point force = lift_of(scene, {nothing, nothing, nothing}, {0, 0, 0.05}, velocity, spin, false);
    const Vec3 way = cross({spin[0], spin[1], spin[2]}, {velocity[0], velocity[1], velocity[2]});
    const double size = std::hypot(force[0], force[1], force[2]), along = norm(way);
    ASSERT_GT(size, 0.0);
    EXPECT_NEAR(force[0] / size, way.x / along, 1e-3);
    EXPECT_NEAR(force[1] / size, way.y / along, 1e-3);
    EXPECT_NEAR(force[2] / size, way.z / along, 1e-3);
    // Between nothing and Rubinow and Keller's π r³ ρ |Ω × v|, which holds in creeping flow.
    EXPECT_LT(size, std::numbers::pi * std::pow(0.0005, 3) * 998.2 * along);
    EXPECT_GT(size, 0.2 * std::numbers::pi * std::pow(0.0005, 3) * 998.2 * along);
  }
}

// Kirchhoff: in still liquid a spin decays as exp(−15 μ t/(ρ_p r²)); in a shear it tends to half the vorticity.
TEST(TorqueInTheBed, RelaxesTheSpinToHalfTheVorticity) {
  const double rate = 15.0 * 1e-3 / (1100.0 * 0.0005 * 0.0005);
  {
    Scene scene = quiescent(0.001, 1100.0, {998.2, 1e-3});
    scene.coupling.magnus_lift = true;
    scene.fluid.time_step = scene.contact.time_step = 0.002 / rate;
    CoupledCase bed(scene);
    bed.add({0, 0, 0.05}, {0, 0, 0}, {3.0, -4.0, 5.0});
    bed.run(1.0 / rate);
    const auto spin = bed.engine.particles.angular_velocity.at(0);
    for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(spin[a], Point({3.0, -4.0, 5.0})[a] * std::exp(-1.0), 0.01) << a;
  }
  Scene scene = sheared_box();
  scene.coupling.magnus_lift = true;
  scene.fluid.time_step = scene.contact.time_step = 0.05 / rate;
  scene.species.front().density = 998.2;
  const double along_x = 6.0, along_y = -3.0;
  CoupledCase bed(scene);
  bed.add({0.001, 0.001, 0.021}, {0.0, 0.0, (along_x + along_y) * 0.001});
  const Field stream = [=](const Point& x) { return along_x * x[0] + along_y * x[1]; };
  start_from(*bed.liquid, {nothing, nothing, stream}, nothing);
  auto& inlet = bed.liquid->end_velocity(2, 0);
  for (std::size_t s = 0; s < inlet.size(); ++s)
    inlet[s] = stream(bed.liquid->position(2, s * (bed.liquid->nodes(2) / inlet.size())));
  // Six relaxation times, a hundredth of the time in which the walls would be felt.
  bed.run(6.0 / rate);
  const auto spin = bed.engine.particles.angular_velocity.at(0);
  EXPECT_NEAR(spin[0], 0.5 * along_y, 0.01 * along_x);
  EXPECT_NEAR(spin[1], -0.5 * along_x, 0.01 * along_x);
  EXPECT_NEAR(spin[2], 0.0, 0.01 * along_x);
}

Scene everything_on(Interpolation interpolation, MomentumExchange exchange) {
  Scene scene;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.12;
  scene.liquid = {998.2, 1e-3, 0.08};
  scene.fluid.cells_across = 4;
  scene.fluid.cell_height = 0.0075;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230, 90}, {"steel", 0.006, 7800, 0}};
  scene.contact.stiffness = 1e3;
  scene.contact.rolling_friction = 0.0175;
  scene.contact.time_step = 1e-4;
  scene.coupling.interpolation = interpolation;
  scene.coupling.exchange = exchange;
  scene.coupling.added_mass = 0.5;
  scene.coupling.saffman_lift = scene.coupling.magnus_lift = scene.coupling.basset_history = true;
  scene.coupling.disturbance_correction = true;
  scene.coupling.smoothing_length = 0.008;
  Stage settle, fluidise, drop;
  settle.kind = StageKind::settle;
  settle.duration = 0.1;
  fluidise.kind = StageKind::fluidise;
  fluidise.duration = 0.1;
  drop.kind = StageKind::drop;
  drop.species = "steel";
  drop.release_height = 0.11;
  drop.duration = 0.12;
  drop.relaxation = 0.02;
  drop.repetitions = 2;
  scene.stages = {settle, fluidise, drop};
  return scene;
}

// With every switch on, a run that is stopped in each of its stages goes on bit by bit.
TEST(ForcesBeyondDragInARun, ContinueAfterAStopBitByBit) {
  for (const auto& [interpolation, exchange] : {std::pair{Interpolation::gradient, MomentumExchange::semi_implicit},
                                                {Interpolation::trilinear, MomentumExchange::implicit}}) {
    const Scene scene = everything_on(interpolation, exchange);
    const auto folder = [&](const char* name) {
      const auto path = std::filesystem::temp_directory_path() / "slfb_coupled_forces_test" / name;
      std::filesystem::remove_all(path);
      return path;
    };
    RunOptions options;
    options.directory = folder("whole");
    const RunResult whole = run_scene(scene, options).result;
    options.directory = folder("stopped");
    const std::array moments{0.05, 0.15, 0.28, 1e9};
    std::size_t stops = 0;
    RunOutcome outcome;
    do {
      std::atomic<bool> stop = false;
      options.stop = &stop;
      options.progress = [&](const Progress& progress) {
        if (progress.simulated_seconds > moments.at(stops)) stop = true;
      };
      options.progress_interval = 0.0;
      outcome = run_scene(scene, options);
      if (outcome.status == RunStatus::interrupted) ++stops;
    } while (outcome.status == RunStatus::interrupted);
    EXPECT_EQ(stops, 3u);
    ASSERT_EQ(whole.drops.size(), 2u);
    ASSERT_EQ(outcome.result.drops.size(), 2u);
    EXPECT_EQ(whole.drops.back().z, outcome.result.drops.back().z);
    EXPECT_EQ(whole.drops.back().angular_speed, outcome.result.drops.back().angular_speed);
    EXPECT_EQ(whole.bed.pressure_drop.back(), outcome.result.bed.pressure_drop.back());
    EXPECT_EQ(whole.bed.centre_of_mass_height.back(), outcome.result.bed.centre_of_mass_height.back());
  }
}

}  // namespace
}  // namespace slfb
