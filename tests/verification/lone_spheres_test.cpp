// Spheres without neighbours fall as their law says on any grid; beds are what they were; nothing is lost in between.
#include "solver/coupling/lone_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <string>

#include "correlations/fluidisation/bed_expansion.hpp"
#include "solver/run/simulation.hpp"
#include "tests/verification/coupled_cases.hpp"

namespace slfb {
namespace {

struct Fall {
  const char* name;
  Species sphere;
  LiquidProperties liquid;
  double height;  ///< of the column, enough for its way [m]
};
// Re of 7000 and of 0.09.
const std::array falls{Fall{"steel in water", {"steel", 6e-3, 7800.0, 1}, {998.2, 1e-3}, 0.45},
                       Fall{"glass in glycerol and water", {"glass", 1e-3, 2500.0, 1}, {1200.0, 0.1}, 0.12}};

Scene still_column(const Fall& fall, FluidTier tier, int cells_across) {
  Scene scene;
  scene.geometry.diameter = 0.05;
  scene.geometry.height = fall.height;
  scene.liquid = {fall.liquid.density, fall.liquid.viscosity, 0.0};
  scene.fluid.tier = tier;
  scene.fluid.cells_across = cells_across;
  scene.fluid.cell_height = 0.05 / cells_across;
  scene.species = {fall.sphere};
  scene.contact.stiffness = 1e4;
  return scene;
}

/// Speed in the steady part of a fall, over the law's terminal velocity.
double speed_over_law(const Fall& fall, FluidTier tier, int cells_across) {
  Scene scene = still_column(fall, tier, cells_across);
  const double terminal = fluidisation::superficial_velocity(
      find_drag_law(scene.coupling.drag_law), {fall.sphere.diameter, fall.sphere.density}, fall.liquid, 1.0);
  constexpr double step = 1e-3;
  scene.fluid.time_step = scene.contact.time_step = step;
  CoupledCase column(scene);
  // Off the axis, where it meets cells in all ways; at a speed that is not its own, with time to find it.
  column.add({0.0031, 0.0017, 0.9 * fall.height}, {0.0, 0.0, -0.9 * terminal});
  column.run(1.6 * terminal / gravitational_acceleration + 10.0 * step);
  const double first = column.engine.particles.position.z[0];
  const double steps = std::max(20.0, std::round(2.0 * 0.05 / cells_across / (terminal * step)));
  column.run(steps * step);
  return (first - column.engine.particles.position.z[0]) / (steps * step) / terminal;
}

class LoneSphereFalls : public testing::TestWithParam<FluidTier> {};

TEST_P(LoneSphereFalls, AtItsLawsTerminalVelocityOnAnyGrid) {
  for (const Fall& fall : falls)
    for (const int cells : {7, 8, 12, 14})
      EXPECT_NEAR(speed_over_law(fall, GetParam(), cells), 1.0, 0.02) << fall.name << ", " << cells << " across";
}

INSTANTIATE_TEST_SUITE_P(Tiers, LoneSphereFalls,
                         testing::Values(FluidTier::one_dimensional, FluidTier::three_dimensional));

// Volume and momentum that are spread are the sphere's, also at the ends of the column and partly among others.
TEST(LoneSpheres, GiveWhatTheyTake) {
  for (const double z : {0.003, 0.05, 0.2, 0.447}) {
    Scene scene = still_column(falls[0], FluidTier::three_dimensional, 8);
    scene.liquid.superficial_velocity = 0.1;
    scene.fluid.time_step = scene.contact.time_step = 1e-3;
    CoupledCase column(scene);
    column.add({0.004, -0.01, z}, {0.1, -0.2, -0.5});
    column.add({-0.012, 0.01, 0.06}, {0.1, -0.2, -0.5});
    for (int step = 0; step < 2; ++step) {
      column.exchange->advance(column.engine, scene.fluid.time_step);
      for (std::size_t a : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        double gained = 0.0, size = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
          gained += column.exchange->drag_force(i, a);
          size += std::abs(column.exchange->drag_force(i, a));
        }
        EXPECT_NEAR(gained, column.exchange->drag_taken_from_liquid(a), 1e-12 * size) << z;
      }
      const auto& liquid = column.exchange->liquid_volume();
      const double held = std::accumulate(liquid.begin(), liquid.end(), 0.0);
      const double whole = scene.geometry.cross_section() * scene.geometry.height;
      EXPECT_NEAR(whole - held, 2.0 * falls[0].sphere.volume(), 1e-12 * whole) << z;
    }
  }
}

/// λ of a sphere at height z over a bed of 8 layers of spheres.
double weight_over_bed(double z) {
  Scene scene = still_column(falls[0], FluidTier::three_dimensional, 8);
  const fluid::ColumnGrid grid(scene);
  coupling::VolumeShares shares(coupling::make_share_scheme(scene.coupling), grid, 0.003);
  dem::VectorField centres;
  std::vector<double> radii, volumes, solid;
  const auto add = [&](double x, double y, double height) {
    centres.x.push_back(x), centres.y.push_back(y), centres.z.push_back(height);
    radii.push_back(0.003), volumes.push_back(dem::Particles::volume_of(0.003));
  };
  add(0.0, 0.0, z);
  for (int k = 0; k < 8; ++k)
    for (double x = -0.021; x < 0.0215; x += 0.007)
      for (double y = -0.021; y < 0.0215; y += 0.007)
        if (std::hypot(x, y) < 0.0221) add(x, y, 0.0035 + 0.007 * k);
  shares.update(centres, radii, 1);
  shares.scatter(volumes, solid);
  coupling::LoneSpheres lone(grid, true);
  lone.update(centres.z, radii, shares, volumes, solid);
  return lone.weight(0);
}

// From alone to among others without a jump: 1 high above a bed, 0 in it, never rising on the way down.
TEST(LoneSpheres, EnterABedSmoothly) {
  EXPECT_EQ(weight_over_bed(0.2), 1.0);
  EXPECT_EQ(weight_over_bed(0.03), 0.0);
  constexpr double step = 2e-4;
  for (double z = 0.1; z > 0.03; z -= step) {
    const double here = weight_over_bed(z), next = weight_over_bed(z - step);
    EXPECT_LE(next, here + 1e-3) << z;
    EXPECT_GT(next, here - 0.1) << z;
  }
}

Scene bed_of(OwnVolume own_volume, double superficial_velocity) {
  Scene scene;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.2;
  scene.liquid = {998.2, 1e-3, superficial_velocity};
  scene.fluid.cells_across = 5;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230, 250}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.coupling.own_volume = own_volume;
  scene.stages.resize(2);
  scene.stages[0].kind = StageKind::settle;
  scene.stages[0].duration = 0.4;
  scene.stages[1].kind = StageKind::fluidise;
  scene.stages[1].duration = 4.0;
  return scene;
}

// A bed of uniform spheres: in a packed one, where none is alone, bit by bit the same; fluidised it stands as high, and
// pressure and weight balance in every step.
TEST(LoneSpheres, LeaveABedAsItIs) {
  const auto run = [](const Scene& scene) {
    RunOptions options;
    options.directory = std::filesystem::temp_directory_path() / "slfb_lone_spheres_test" /
                        std::to_string(scene.liquid.superficial_velocity) /
                        std::to_string(static_cast<int>(scene.coupling.own_volume));
    std::filesystem::remove_all(options.directory);
    return run_scene(scene, options).result;
  };
  const auto height = [](const RunResult& result) {
    const auto& series = result.bed.centre_of_mass_height;
    const auto from = series.begin() + static_cast<std::ptrdiff_t>(series.size() / 4);
    return std::accumulate(from, series.end(), 0.0) / static_cast<double>(series.end() - from);
  };
  const RunResult counted = run(bed_of(OwnVolume::counted, 0.08)),
                  spread = run(bed_of(OwnVolume::spread_where_alone, 0.08));
  EXPECT_NEAR(height(spread), height(counted), 0.03 * height(counted));
  EXPECT_LT(*std::max_element(spread.bed.balance_residual.begin(), spread.bed.balance_residual.end()), 1e-6);
  Scene packed = bed_of(OwnVolume::counted, 0.02);
  packed.stages[1].duration = 0.3;
  const RunResult one = run(packed);
  packed.coupling.own_volume = OwnVolume::spread_where_alone;
  EXPECT_EQ(one.bed.pressure_drop, run(packed).bed.pressure_drop);
}

}  // namespace
}  // namespace slfb
