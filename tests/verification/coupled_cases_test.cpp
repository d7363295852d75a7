// Cases of spheres in liquid whose truth is known: a sphere alone, a bed at rest, a frozen bed, a fluidised one.
#include "tests/verification/coupled_cases.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <numeric>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/ergun_1952.hpp"
#include "correlations/drag/single_sphere/schiller_naumann_1935.hpp"
#include "correlations/drag/wen_yu_1966.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/materials.hpp"
#include "solver/dem/packing.hpp"
#include "solver/run/one_particle.hpp"
#include "solver/run/simulation.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

/// Root of a rising function by bisection.
template <class F>
double root_of(const F& f, double low, double high) {
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Speed at which Wen and Yu's law carries the buoyant weight of a sphere alone.
double terminal_speed(double diameter, double density, LiquidProperties liquid) {
  const double volume = std::numbers::pi / 6.0 * diameter * diameter * diameter;
  return root_of(
      [&](double speed) {
        const double law = drag::WenYu1966{}({1.0, liquid.density * diameter * speed / liquid.viscosity});
        return 3.0 * std::numbers::pi * liquid.viscosity * diameter * speed * law -
               (density - liquid.density) * volume * gravitational_acceleration;
      },
      0.0, 10.0);
}

struct LoneSphere {
  double diameter, density;
  LiquidProperties liquid;
};
// Re of 5e-3, 4, 140, 1700, 6600.
constexpr std::array lone_spheres{LoneSphere{1e-4, 2230.0, {1200.0, 0.02}}, LoneSphere{5e-3, 2230.0, {1200.0, 0.3}},
                                  LoneSphere{1e-3, 2230.0, {998.2, 1e-3}}, LoneSphere{5e-3, 2230.0, {998.2, 1e-3}},
                                  LoneSphere{6e-3, 7800.0, {998.2, 1e-3}}};

Scene quiescent(const LoneSphere& sphere, double stream) {
  Scene scene = periodic_box(0.05, 0.1, 4, stream);
  scene.liquid = {sphere.liquid.density, sphere.liquid.viscosity, stream};
  scene.fluid.tier = FluidTier::quiescent;
  scene.coupling.drag_law = "wen-yu-1966";
  scene.species = {{"sphere", sphere.diameter, sphere.density, 1}};
  const double terminal = terminal_speed(sphere.diameter, sphere.density, sphere.liquid);
  scene.fluid.time_step = scene.contact.time_step = 0.02 * terminal / gravitational_acceleration;
  return scene;
}

// From rest to the terminal velocity: on the way as CVODE has it, at the end the law's root, over six decades of Re.
TEST(LoneSphereInTheBed, SettlesAsTheReferenceAndEndsAtTheLawsRoot) {
  for (const LoneSphere& sphere : lone_spheres) {
    const double terminal = terminal_speed(sphere.diameter, sphere.density, sphere.liquid);
    const Scene scene = quiescent(sphere, 0.0);
    CoupledCase bed(scene);
    bed.add({0, 0, 0});
    OneParticleFall fall;
    fall.diameter = sphere.diameter;
    fall.density = sphere.density;
    fall.liquid_density = fall.surrounding_density = sphere.liquid.density;
    fall.viscosity = sphere.liquid.viscosity;
    // Rounded to steps, so that both are at the same time.
    std::vector<double> times{0.0};
    for (const double k : {10.0, 50.0, 100.0, 200.0, 1000.0}) times.push_back(k * scene.fluid.time_step);
    const auto reference = integrate_fall(fall, times);
    for (std::size_t k = 1; k < times.size(); ++k) {
      bed.run(times[k] - times[k - 1]);
      EXPECT_NEAR(bed.engine.particles.velocity.z[0], reference[k].velocity, 0.01 * terminal)
          << sphere.diameter << ", " << times[k];
    }
    EXPECT_NEAR(bed.engine.particles.velocity.z[0], -terminal, 1e-3 * terminal) << sphere.diameter;
  }
}

// In liquid that rises with the terminal velocity a sphere hovers, and is carried there if it starts elsewhere.
TEST(LoneSphereInTheBed, HoversWhereTheLiquidRisesAsItFalls) {
  for (const LoneSphere& sphere : lone_spheres) {
    const double terminal = terminal_speed(sphere.diameter, sphere.density, sphere.liquid);
    const Scene scene = quiescent(sphere, terminal);
    CoupledCase bed(scene);
    bed.add({0, 0, 0}, {0.0, 0.0, 0.0});
    bed.add({1.0, 0, 0}, {0.3 * terminal, 0.0, -0.5 * terminal});
    bed.run(1500.0 * scene.fluid.time_step);
    EXPECT_NEAR(bed.engine.particles.velocity.z[0], 0.0, 1e-4 * terminal) << sphere.diameter;
    EXPECT_NEAR(bed.engine.particles.position.z[0], 0.0,
                0.02 * terminal * 30.0 * terminal / gravitational_acceleration);
    EXPECT_NEAR(bed.engine.particles.velocity.z[1], 0.0, 2e-3 * terminal) << sphere.diameter;
    EXPECT_NEAR(bed.engine.particles.velocity.x[1], 0.0, 2e-3 * terminal) << sphere.diameter;
  }
}

/// Slip of a sphere on a grid against the undisturbed stream over the terminal velocity, less 1.
double slip_error(double cells_per_diameter, double reynolds, bool corrected) {
  const double d = 1e-3, cell = cells_per_diameter * d, density = 2500.0;
  // The viscosity that makes the terminal velocity's Reynolds number.
  LiquidProperties liquid{1000.0, 1e-3};
  liquid.viscosity = root_of(
      [&](double viscosity) {
        return reynolds - 1000.0 * d * terminal_speed(d, density, {1000.0, viscosity}) / viscosity;
      },
      1e-5, 1.0);
  const double terminal = terminal_speed(d, density, liquid);
  Scene scene = periodic_box(12.0 * cell, 24.0 * cell, 12, terminal);
  scene.liquid = {liquid.density, liquid.viscosity, terminal};
  scene.coupling.drag_law = "wen-yu-1966";
  scene.coupling.disturbance_correction = corrected;
  scene.species = {{"sphere", d, density, 1}};
  scene.fluid.pressure_tolerance = 1e-8;
  scene.fluid.time_step = scene.contact.time_step = 0.2 * cell / terminal;
  CoupledCase bed(scene);
  start_from(
      *bed.liquid,
      {[](const Point&) { return 0.0; }, [](const Point&) { return 0.0; }, [&](const Point&) { return terminal; }},
      [](const Point&) { return 0.0; });
  bed.add({0.3 * cell, 0.2 * cell, 15.4 * cell});
  bed.run(10.0 * cell / terminal);
  const double z = bed.engine.particles.position.z[0];
  bed.run(4.0 * cell / terminal);
  const double speed = (bed.engine.particles.position.z[0] - z) / (4.0 * cell / terminal);
  return (terminal - speed) / terminal - 1.0;
}

// A sphere reads liquid that its own drag has slowed, and cells that its own volume fills. The first lets it fall too
// fast (known since Gualtieri et al. 2015, Horwitz & Mani 2016), the second, through the law's α^-3.65, too slowly; in
// cells of a diameter they cancel by chance at one Re and not at another. Ours, slip over the terminal velocity less 1:
//
//     cell/d            0.7     1.0     1.5     2.0     3.0     5.0    10.0
//     Re 2   without  +0.008  +0.103  +0.247  +0.242  +0.175  +0.091  +0.027
//            with     -0.085  +0.007  +0.031  +0.056  +0.028  +0.007   0.000
//     Re 50  without  -0.157  -0.123  -0.001  -0.021  +0.004  +0.006  +0.002
//            with     -0.004  -0.010  -0.024  -0.012  -0.006  -0.002   0.000
//
// The correction leaves at most a third of what exceeds 3 %, never more than 10 %, and 1 % in cells of five diameters.
TEST(LoneSphereOnTheGrid, IsDisturbedByItselfAndTheCorrectionTakesThatAway) {
  for (const double reynolds : {2.0, 50.0}) {
    for (const double ratio : {0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0}) {
      const double plain = slip_error(ratio, reynolds, false), corrected = slip_error(ratio, reynolds, true);
      fmt::print("Re {:4.0f}  cell/d {:4.1f}  without {:+7.3f}  with {:+7.3f}\n", reynolds, ratio, plain, corrected);
      RecordProperty(fmt::format("re{:g}_cell{:g}_without", reynolds, ratio), fmt::format("{:.4f}", plain));
      RecordProperty(fmt::format("re{:g}_cell{:g}_with", reynolds, ratio), fmt::format("{:.4f}", corrected));
      EXPECT_LT(std::abs(corrected), ratio < 5.0 ? 0.1 : 0.01) << ratio;
      if (std::abs(plain) > 0.03) {
        EXPECT_LT(std::abs(corrected), std::abs(plain) / 3.0) << ratio;
      }
    }
  }
}

/// Volume of a sphere below a plane.
double volume_below(double z, double centre, double radius) {
  const double h = std::clamp(z - centre + radius, 0.0, 2.0 * radius);
  return std::numbers::pi * h * h * (3.0 * radius - h) / 3.0;
}

// A settled frictional bed at rest in slower liquid than U_mf. Layer by layer Ergun's equation in its own form,
// 150 α_S² μ U/(α³ d²) + 1.75 α_S ρ U²/(α³ d), at the layer's voidage, measured from the spheres alone. In one
// dimension the drop is 3 % less: a sphere reads the mean voidage of the layers it lies in, which smooths their
// unevenness (Ergun's drop is convex in the voidage), and the surface of a bed of 13 layers is smeared over one; both
// fade with the layers' height over the diameter and the bed's. In the column the liquid also finds its way along the
// wall, where the spheres leave room: less again, by some percent.
TEST(BedAtRest, HasErgunsPressureDropAtItsVoidage) {
  Scene scene;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.24;
  scene.liquid = {998.2, 1e-3, 0.0};
  scene.fluid.wall = LateralBoundary::slip;
  scene.fluid.tier = FluidTier::quiescent;
  scene.fluid.time_step = 1e-3;
  scene.fluid.cells_across = 5;
  scene.fluid.cell_height = 0.00625;
  scene.species = {{"glass", 0.005, 2230, 500}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.coupling.drag_law = "ergun-1952";
  CoupledCase settling(scene, dem::walls_of(scene));
  for (const dem::PlacedSphere& sphere : dem::start_positions(scene)) settling.add(sphere.centre);
  settling.run(1.0);

  for (const FluidTier tier : {FluidTier::one_dimensional, FluidTier::three_dimensional})
    for (const double velocity : {0.01, 0.03}) {
      scene.fluid.tier = tier;
      scene.liquid.superficial_velocity = velocity;
      CoupledCase bed(scene, dem::walls_of(scene));
      for (std::size_t i = 0; i < settling.engine.particles.size(); ++i)
        bed.add(settling.engine.particles.position.at(i));
      bed.run(0.2);
      const auto& grid = bed.liquid->grid();
      const double area = grid.section_area(), h = grid.cell_height(), d = 0.005;
      double expected = 0.0, upward = 0.0;
      for (int k = 0; k < grid.layers(); ++k) {
        double volume = 0.0;
        for (const double z : bed.engine.particles.position.z)
          volume += volume_below((k + 1) * h, z, 0.5 * d) - volume_below(k * h, z, 0.5 * d);
        const double s = volume / (area * h), a = 1.0 - s;
        expected += h * (150.0 * s * s * 1e-3 * velocity / (a * a * a * d * d) +
                         1.75 * s * 998.2 * velocity * velocity / (a * a * a * d));
      }
      for (const double v : bed.engine.particles.velocity.z) upward = std::max(upward, std::abs(v));
      ASSERT_LT(upward, 1e-3) << "the bed is not at rest";
      const double ratio = bed.liquid->inlet_pressure() / expected;
      fmt::print("{} at {} m/s: {:.2f} Pa, Ergun over the layers {:.2f} Pa, ratio {:.4f}\n",
                 tier == FluidTier::one_dimensional ? "1-D" : "3-D", velocity, bed.liquid->inlet_pressure(), expected,
                 ratio);
      if (tier == FluidTier::one_dimensional) {
        EXPECT_LT(ratio, 1.0) << velocity;
        EXPECT_GT(ratio, 0.96) << velocity;
      } else {
        EXPECT_LT(ratio, 1.0) << velocity;
        EXPECT_GT(ratio, 0.85) << velocity;
      }
    }
}

/// Net force on a sphere in the middle of a frozen bed whose every layer holds the same solids.
double net_force(const std::string& law, double velocity, bool drag_times_voidage = false) {
  Scene scene = periodic_box(0.03, 0.12, 1, velocity);
  scene.fluid.tier = FluidTier::one_dimensional;
  scene.fluid.wall = LateralBoundary::slip;
  scene.fluid.cell_height = 0.006;
  scene.coupling.drag_law = law;
  scene.coupling.drag_times_voidage = drag_times_voidage;
  CoupledCase bed(scene);
  // Whole spheres inside each layer; that some overlap does not matter where nothing moves.
  for (int k = 0; k < 20; ++k)
    for (int n = 0; n < 41; ++n) bed.add({0.012 * std::sin(n), 0.012 * std::cos(1.3 * n), (k + 0.5) * 0.006});
  for (int k = 0; k < 6; ++k) bed.exchange->advance(bed.engine, scene.fluid.time_step);
  return bed.engine.external_force.z[10 * 41];
}

// The superficial velocity at which a uniform frozen bed is carried is the law's own root: drag, β U/α per volume of
// bed and α of the pressure gradient's other part, adds up to β U/α² = (1 − α)(ρ_p − ρ) g.
TEST(FrozenBed, IsCarriedAtTheLawsRoot) {
  const double solids = 41 * dem::Particles::volume_of(0.0025) / (0.03 * 0.03 * 0.006), voidage = 1.0 - solids;
  for (const std::string name :
       {"wen-yu-1966", "ergun-1952", "di-felice-1994", "gibilaro-1985", "beetstra-2007", "koch-hill-2001"}) {
    const double expected = drag::with_drag_law(name, [&](auto law) {
      return root_of(
          [&](double velocity) {
            const double beta =
                drag::exchange_coefficient(law({voidage, 998.2 * 0.005 * velocity / 1e-3}), voidage, 0.005, 1e-3);
            return beta * velocity / (voidage * voidage) - solids * (2230.0 - 998.2) * gravitational_acceleration;
          },
          1e-4, 1.0);
    });
    const double found =
        root_of([&](double velocity) { return net_force(name, velocity); }, 0.5 * expected, 2.0 * expected);
    EXPECT_NEAR(found, expected, 1e-3 * expected) << name;
  }
}

// Eq. 20 of Peng 2014 as printed, α f_d: the bed is carried where α β U/α² is its weight, and what the spheres gain by
// the drag the liquid has lost.
TEST(FrozenBed, IsCarriedByTheDragTimesVoidage) {
  const double solids = 41 * dem::Particles::volume_of(0.0025) / (0.03 * 0.03 * 0.006), voidage = 1.0 - solids;
  const std::string law = "ergun-1952";
  const double expected = root_of(
      [&](double velocity) {
        const double beta = 150.0 * solids * solids * 1e-3 / (voidage * 0.005 * 0.005) +
                            1.75 * solids * 998.2 * velocity / voidage / 0.005;
        return beta * velocity / voidage - solids * (2230.0 - 998.2) * gravitational_acceleration;
      },
      1e-4, 1.0);
  EXPECT_NEAR(root_of([&](double velocity) { return net_force(law, velocity, true); }, 0.5 * expected, 2.0 * expected),
              expected, 1e-3 * expected);
}

Scene small_bed(double fluid_step) {
  Scene scene;
  scene.geometry.diameter = 0.025;
  scene.geometry.height = 0.14;
  scene.liquid = {998.2, 1e-3, 0.1};
  scene.fluid.cells_across = 4;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = fluid_step;
  scene.species = {{"glass", 0.005, 2230, 150}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.recording.bed_interval = fluid_step;
  Stage settle, fluidise;
  settle.kind = StageKind::settle;
  settle.duration = 0.2;
  fluidise.kind = StageKind::fluidise;
  fluidise.duration = 2.0;
  scene.stages = {settle, fluidise};
  return scene;
}

RunResult run(const Scene& scene, const char* name) {
  RunOptions options;
  options.directory = std::filesystem::temp_directory_path() / "slfb_coupled_cases_test" / name;
  std::filesystem::remove_all(options.directory);
  return run_scene(scene, options).result;
}

double mean(const std::vector<double>& values, double from_part = 0.0) {
  const auto first = static_cast<std::ptrdiff_t>(from_part * static_cast<double>(values.size()));
  return std::accumulate(values.begin() + first, values.end(), 0.0) /
         static_cast<double>(values.size() - static_cast<std::size_t>(first));
}

// Long steps: 1 ms of liquid to ten of the spheres. Everything that acts along z, each from where it arises, closes to
// 1e-6 of the weight in every single step, with friction and walls that hold; and the bed is that of steps ten times
// shorter.
TEST(FluidisedBed, BalanceClosesInEveryStepAlsoOfLongOnes) {
  std::array<double, 2> height{}, drop{};
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}}) {
    const RunResult result = run(small_bed(n == 0 ? 1e-3 : 2e-4), n == 0 ? "long" : "short");
    const BedSeries& bed = result.bed;
    ASSERT_GT(bed.time.size(), 1900u);
    const double area = 0.25 * std::numbers::pi * 0.025 * 0.025, weight = -bed.buoyant_weight.back();
    EXPECT_NEAR(weight, 150 * (2230 - 998.2) * dem::Particles::volume_of(0.0025) * gravitational_acceleration,
                1e-9 * weight);
    double largest = 0.0;
    for (std::size_t k = 1; k < bed.time.size(); ++k) {
      const double sum = bed.pressure_force[k] + bed.buoyant_weight[k] + bed.bottom_force[k] + bed.wall_force[k] +
                         bed.shear_force[k] + bed.flow_force[k] + bed.sphere_inertia[k] + bed.liquid_inertia[k];
      largest = std::max({largest, std::abs(sum) / weight, bed.balance_residual[k]});
      // The pressure force is what a gauge at the inlet shows.
      EXPECT_NEAR(bed.pressure_force[k], bed.pressure_drop[k] * area, 1e-9 * weight);
    }
    EXPECT_LT(largest, 1e-6);
    height[n] = mean(bed.centre_of_mass_height, 0.4);
    drop[n] = mean(bed.pressure_drop, 0.4) * area / weight;
    const std::array<std::pair<const char*, const std::vector<double>*>, 7> terms{
        {{"pressure", &bed.pressure_force},
         {"bottom", &bed.bottom_force},
         {"walls", &bed.wall_force},
         {"shear", &bed.shear_force},
         {"flow", &bed.flow_force},
         {"sphere inertia", &bed.sphere_inertia},
         {"liquid inertia", &bed.liquid_inertia}}};
    fmt::print("step {:.4f} s: residual {:.1e}; over the weight", result.bed.time[1] - result.bed.time[0], largest);
    for (const auto& [name, series] : terms) {
      double square = 0.0;
      for (const double f : *series) square += f * f;
      const double rms = std::sqrt(square / static_cast<double>(series->size())) / weight;
      fmt::print(", {} {:+.4f} (rms {:.4f})", name, mean(*series, 0.4) / weight, rms);
      // A balance of terms that are not there would close too.
      EXPECT_GT(rms, 1e-6) << name;
    }
    fmt::print("\n");
    EXPECT_LT(mean(bed.shear_force, 0.4), 0.0);
  }
  EXPECT_NEAR(height[0], height[1], 0.05 * height[1]);
  EXPECT_NEAR(drop[0], drop[1], 0.02);
}

// Where walls are frictionless, pressure and distributor carry the weight, with the momentum that the liquid brings: it
// enters with U/α of the packed bottom and leaves with U, which is 2 % of the weight here. On average, when what moves
// has no more momentum than before.
TEST(FluidisedBed, PressureAndBottomCarryTheWeight) {
  Scene scene = small_bed(1e-3);
  scene.fluid.wall = LateralBoundary::slip;
  scene.contact.sliding_friction = 0.0;
  scene.stages[1].duration = 4.0;
  const BedSeries bed = run(scene, "slip").bed;
  const double weight = -bed.buoyant_weight.back();
  const double carried = mean(bed.pressure_force, 0.25) + mean(bed.bottom_force, 0.25) + mean(bed.flow_force, 0.25);
  fmt::print("carried over weight {:.5f}, of it by the bottom {:.5f}, by the flow {:.5f}\n", carried / weight,
             mean(bed.bottom_force, 0.25) / weight, mean(bed.flow_force, 0.25) / weight);
  EXPECT_NEAR(carried, weight, 5e-3 * weight);
}

}  // namespace
}  // namespace slfb
