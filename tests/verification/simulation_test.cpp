// Whole runs of a small bed: reproducibility, resumption, conservation of spheres, the weight the liquid carries.
#include "solver/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "correlations/materials.hpp"
#include "solver/laws/scene_file.hpp"

namespace slfb {
namespace {

Scene small_bed(double superficial_velocity) {
  Scene scene;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.2;
  scene.liquid = {998.2, 1e-3, superficial_velocity};
  scene.fluid.cells_across = 5;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230, 250}, {"steel", 0.006, 7800, 0}};
  scene.contact.stiffness = 1e3;
  scene.contact.rolling_friction = 0.0175;
  scene.contact.time_step = 1e-4;
  Stage settle, fluidise, drop;
  settle.kind = StageKind::settle;
  settle.duration = 0.4;
  fluidise.kind = StageKind::fluidise;
  fluidise.duration = 0.3;
  drop.kind = StageKind::drop;
  drop.species = "steel";
  drop.release_height = 0.19;
  drop.duration = 1.5;
  drop.relaxation = 0.02;
  drop.repetitions = 2;
  scene.stages = {settle, fluidise, drop};
  return scene;
}

/// Of the running test alone: others may run beside it.
std::filesystem::path fresh_folder(const char* name) {
  std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(test.begin(), test.end(), '/', '_');
  const auto folder = std::filesystem::temp_directory_path() / "slfb_simulation_test" / test / name;
  std::filesystem::remove_all(folder);
  return folder;
}

RunResult run(const Scene& scene, const char* folder, int threads) {
  RunOptions options;
  options.threads = threads;
  options.directory = fresh_folder(folder);
  return run_scene(scene, options).result;
}

void expect_identical(const RunResult& a, const RunResult& b) {
  EXPECT_EQ(a.bed.pressure_drop, b.bed.pressure_drop);
  EXPECT_EQ(a.bed.centre_of_mass_height, b.bed.centre_of_mass_height);
  EXPECT_EQ(a.bed.fluctuating_energy, b.bed.fluctuating_energy);
  ASSERT_EQ(a.drops.size(), b.drops.size());
  for (std::size_t d = 0; d < a.drops.size(); ++d) {
    EXPECT_EQ(a.drops[d].z, b.drops[d].z);
    EXPECT_EQ(a.drops[d].contact_force, b.drops[d].contact_force);
    EXPECT_EQ(a.drops[d].cumulative_contacts, b.drops[d].cumulative_contacts);
  }
}

TEST(Simulation, IsBitwiseTheSameAtAnyNumberOfThreads) {
  const Scene scene = small_bed(0.08);
  const RunResult one = run(scene, "one", 1);
  ASSERT_FALSE(one.bed.time.empty());
  expect_identical(one, run(scene, "two", 2));
  expect_identical(one, run(scene, "three", 3));
}

// Within a bed a sphere waits until there is room, and before a bed that rests against the lid not for ever: the bed
// is what such a run has to tell.
TEST(Simulation, ReleaseWaitsUntilThereIsRoom) {
  Scene scene = small_bed(0.2);
  scene.stages[2].repetitions = 6;
  scene.stages[2].release_height = 0.16;
  const RunResult result = run(scene, "waits", 1);
  ASSERT_EQ(result.drops.size(), 6U);
  double longest = 0.0;  // [s]
  for (std::size_t d = 1; d < result.drops.size(); ++d) {
    const DropSeries& last = result.drops[d - 1];
    const double fall = last.bottom_time > 0.0 ? last.bottom_time : scene.stages[2].duration;
    longest = std::max(longest, result.drops[d].release_time - last.release_time - fall - scene.stages[2].relaxation);
  }
  EXPECT_GT(longest, 0.0015) << "no release had to wait: the test shows nothing";

  Scene risen = small_bed(0.3);
  risen.stages[1].duration = 1.5;
  risen.stages[2].duration = 0.05;
  const RunResult without = run(risen, "waits in vain", 1);
  EXPECT_TRUE(without.drops.empty());
  EXPECT_NEAR(without.bed.time.back(), risen.stages[1].duration + risen.stages[2].duration, 0.011);
}

class Resumption : public testing::TestWithParam<double> {};

// Also within an interval of the void fraction, here of two liquid steps.
TEST_P(Resumption, ContinuesAfterAStopAsIfNothingHadHappened) {
  Scene scene = small_bed(0.08);
  scene.coupling.void_fraction_interval = GetParam();
  RunResult whole = run(scene, "whole", 1);

  RunOptions options;
  options.directory = fresh_folder("interrupted");
  int stops = 0;
  RunOutcome outcome;
  do {
    std::atomic<bool> stop = false;
    // Stop at three awkward moments: in the packed bed, in the fluidised one, while a sphere falls.
    const double moments[] = {0.2, 0.551, 0.952, 1e9};
    options.stop = &stop;
    options.progress = [&](const Progress& progress) {
      if (progress.simulated_seconds > moments[stops]) stop = true;
    };
    options.progress_interval = 0.0;
    outcome = run_scene(scene, options);
    if (outcome.status == RunStatus::interrupted) {
      EXPECT_TRUE(std::filesystem::exists(options.directory / "checkpoint.h5"));
      ++stops;
    }
  } while (outcome.status == RunStatus::interrupted);
  EXPECT_EQ(stops, 3);
  // A crash before the caller has saved the result must not cost the run.
  EXPECT_TRUE(std::filesystem::exists(options.directory / "checkpoint.h5"));
  remove_checkpoints(options.directory);
  EXPECT_TRUE(std::filesystem::is_empty(options.directory));

  // What was recorded before a stop went through the file in single precision; the motion itself must not differ.
  ASSERT_EQ(whole.drops.size(), outcome.result.drops.size());
  const auto& expected = whole.drops.back();
  const auto& actual = outcome.result.drops.back();
  EXPECT_EQ(expected.z, actual.z);
  EXPECT_EQ(expected.cumulative_contacts, actual.cumulative_contacts);
  EXPECT_EQ(whole.bed.time, outcome.result.bed.time);
  EXPECT_EQ(whole.bed.pressure_drop.back(), outcome.result.bed.pressure_drop.back());
  EXPECT_EQ(whole.particle_steps, outcome.result.particle_steps);
}

INSTANTIATE_TEST_SUITE_P(Simulation, Resumption, testing::Values(0.0, 2e-3));

class ExpandedBed : public testing::TestWithParam<FluidTier> {};

// A bed is fluidised high and then taken down, with a stop on the way: it sinks, no momentum is lost when the liquid's
// velocity changes, and a run that was stopped knows the velocity of its stage.
TEST_P(ExpandedBed, IsTakenDownByASecondStage) {
  Scene scene = small_bed(0.05);
  scene.fluid.tier = GetParam();
  scene.species.resize(1);
  scene.stages = {scene.stages[0], scene.stages[1], scene.stages[1]};
  scene.stages[1].superficial_velocity = 0.14;
  scene.stages[1].duration = 0.8;
  scene.stages[2].duration = 0.6;
  scene.recording.bed_interval = scene.fluid.time_step;
  validate_scene(scene);
  const RunResult whole = run(scene, "whole", 1);
  const BedSeries& bed = whole.bed;
  ASSERT_EQ(bed.superficial_velocity.size(), bed.time.size());
  for (std::size_t k = 0; k < bed.time.size(); ++k)
    ASSERT_EQ(bed.superficial_velocity[k], bed.time[k] < 0.8005 ? 0.14 : 0.05) << bed.time[k];
  const auto change =
      static_cast<std::size_t>(std::ranges::find(bed.superficial_velocity, 0.05) - bed.superficial_velocity.begin());
  EXPECT_LT(bed.centre_of_mass_height.back(), 0.9 * bed.centre_of_mass_height[change]);
  EXPECT_LT(*std::max_element(bed.balance_residual.begin(), bed.balance_residual.end()), 1e-6);

  RunOptions options;
  options.directory = fresh_folder("interrupted");
  for (const double moment : {1.1, 1.5, 1e9}) {
    std::atomic<bool> stop = false;
    options.stop = &stop;
    options.progress = [&](const Progress& progress) { stop = stop || progress.simulated_seconds > moment; };
    options.progress_interval = 0.0;
    const RunOutcome outcome = run_scene(scene, options);
    if (outcome.status == RunStatus::interrupted) continue;
    EXPECT_EQ(outcome.result.bed.centre_of_mass_height.back(), bed.centre_of_mass_height.back());
    EXPECT_EQ(outcome.result.bed.pressure_drop.back(), bed.pressure_drop.back());
    EXPECT_EQ(outcome.result.simulated_seconds, whole.simulated_seconds);
  }
}

INSTANTIATE_TEST_SUITE_P(Simulation, ExpandedBed,
                         testing::Values(FluidTier::one_dimensional, FluidTier::three_dimensional));

// In a liquid of given velocity a sphere hangs where the liquid rises with its terminal velocity, and falls when the
// liquid slows down.
TEST(Simulation, ASphereInAGivenLiquidFollowsTheStages) {
  Scene scene = small_bed(0.1);
  scene.fluid.tier = FluidTier::quiescent;
  scene.species = {{"glass", 0.005, 2230, 1}};
  scene.stages = {scene.stages[1], scene.stages[1]};
  scene.stages[0].superficial_velocity = 0.6;  // above its terminal velocity
  const RunResult result = run(scene, "stages", 1);
  const auto& height = result.bed.centre_of_mass_height;
  const std::size_t half = height.size() / 2;
  EXPECT_GT(height[half - 1], height.front());
  EXPECT_LT(height.back(), height[half]);
}

// A fluidised bed is carried by the liquid: Δp A is its buoyant weight, less what walls and distributor bear.
TEST(Simulation, LiquidCarriesTheBed) {
  Scene scene = small_bed(0.1);
  scene.fluid.wall = LateralBoundary::slip;
  scene.contact.sliding_friction = 0.0;
  scene.contact.rolling_friction = 0.0;
  scene.stages.resize(2);
  scene.stages[1].duration = 3.0;
  const RunResult result = run(scene, "weight", 1);
  const double area = std::numbers::pi * 0.015 * 0.015;
  const double weight =
      250 * (2230 - 998.2) * gravitational_acceleration * std::numbers::pi / 6 * std::pow(0.005, 3) / area;
  double sum = 0.0;
  const std::size_t n = result.bed.time.size(), half = n / 2;
  for (std::size_t k = half; k < n; ++k) sum += result.bed.pressure_drop[k];
  EXPECT_NEAR(sum / static_cast<double>(n - half), weight, 0.03 * weight);
}

TEST(Simulation, ExcessiveFlowCarriesSpheresOutAndCountsThem) {
  Scene scene = small_bed(0.8);
  scene.outlet.rule = OutletRule::remove;
  scene.stages.resize(2);
  scene.stages[1].duration = 1.0;
  const RunResult result = run(scene, "wash_out", 1);
  EXPECT_EQ(result.particles_removed, 250);
}

// Spheres leave in steps of snapshots, and in the last step of the stage: both still show the void fraction.
TEST(Simulation, RecordsTheLiquidWhileSpheresLeave) {
  Scene scene = small_bed(1.0);
  scene.outlet.rule = OutletRule::remove;
  scene.stages.resize(2);
  scene.stages[1].duration = 0.3;
  scene.recording.snapshot_interval = scene.fluid.time_step;
  const RunResult result = run(scene, "leaving", 1);
  EXPECT_GT(result.particles_removed, 0);
  const auto cells = result.plane.x.size() * result.plane.z.size();
  EXPECT_GT(cells, 0u);
  EXPECT_EQ(result.plane.voidage.size(), cells);
}

// A light sphere is carried out of the column: it is taken out there and counted, and the next one is released.
TEST(Simulation, ADroppedSphereLeavesThroughTheOutlet) {
  for (const FluidTier tier : {FluidTier::quiescent, FluidTier::one_dimensional, FluidTier::three_dimensional}) {
    Scene scene = small_bed(0.3);
    scene.fluid.tier = tier;
    scene.outlet.rule = OutletRule::remove;
    scene.species = {{"light", 0.003, 1100, 0}};
    scene.stages = {scene.stages[1], scene.stages[2]};
    scene.stages[0].duration = 0.1;
    scene.stages[1].species = "light";
    scene.stages[1].release_height = 0.15;
    scene.stages[1].duration = 3.0;
    const RunResult result = run(scene, "light", 1);
    EXPECT_EQ(result.particles_removed, 2);
    ASSERT_EQ(result.drops.size(), 2u);
    for (const DropSeries& drop : result.drops) {
      ASSERT_FALSE(drop.z.empty());
      EXPECT_GE(drop.z.back(), 0.99 * scene.geometry.height);
      EXPECT_LT(*std::max_element(drop.z.begin(), drop.z.end()), scene.geometry.height + 0.3 * 1e-3);
      EXPECT_LT(drop.bottom_time, 0.0);
    }
  }
}

TEST(Simulation, SavesItsStateWhenItBreaksDown) {
  Scene scene = small_bed(0.08);
  scene.contact.time_step = 1e-3;  // far above the bound: the packing explodes
  scene.contact.allow_large_time_step = true;
  RunOptions options;
  options.directory = fresh_folder("failure");
  try {
    run_scene(scene, options);
    FAIL() << "a packing at four times its stable step must not survive";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("sphere"), std::string::npos) << error.what();
    EXPECT_TRUE(std::filesystem::exists(options.directory / "failure.h5"));
  }
}

}  // namespace
}  // namespace slfb
