#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments/runs/run_estimate.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"
#include "solver/support/folders.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/synthetic_runs.hpp"

namespace slfb {
namespace {

TEST(RunEstimate, CountsStepsOfTheScene) {
  const RunEstimate estimate = estimate_run(synthetic::scene(0.06));
  EXPECT_EQ(estimate.spheres, 3600);
  // 8 x 8 squares of 6.25 mm, 12 of them joined to their neighbours, in 160 layers.
  EXPECT_EQ(estimate.liquid_cells, 52 * 160);
  // 1 s settling, 4 s fluidised, three falls of 3 s (6 s at most) with 0.5 s between them.
  EXPECT_DOUBLE_EQ(estimate.simulated_seconds, 15.5);
  EXPECT_DOUBLE_EQ(estimate.longest_seconds, 24.5);
  EXPECT_NEAR(static_cast<double>(estimate.particle_steps), 3601 * 15.5 / 5e-5, 1.0);
  EXPECT_NEAR(static_cast<double>(estimate.cell_steps), 52 * 160 * 14.5 / 1e-3, 1.0);
  // Two 5 mm spheres of 2230 kg/m³ weigh 0.1459 g each: 1/ω_0 = √(0.0730 g / 1e3 N/m) = 0.270 ms.
  EXPECT_NEAR(estimate.time_step_bound, 2.70e-4, 0.01e-4);
  EXPECT_NEAR(estimate.steps_per_contact, std::numbers::pi * 2.70e-4 / 5e-5, 0.1);
}

TEST(RunEstimate, AQuiescentLiquidHasNoCells) {
  Scene scene = synthetic::scene(0.0);
  scene.fluid.tier = FluidTier::quiescent;
  EXPECT_EQ(estimate_run(scene).liquid_cells, 0);
  EXPECT_EQ(estimate_run(scene).cell_steps, 0);
}

// What is counted before a run is what the run does: each sphere in each step, and the liquid's steps, of which each
// leaves a sample here.
TEST(RunEstimate, CountsWhatARunDoes) {
  const Scene scene = load_scene(source_folder() / "experiments/scenes/fluidised_box.toml",
                                 {"species[0].count=60", "geometry.height=0.1 m", "stage[0].duration=0.2 s",
                                  "stage[1].duration=0.1 s", "recording.bed_interval=1 ms"});
  const Folder folder;
  const RunResult result = run_scene(scene, {.directory = folder.path()}).result;
  const RunEstimate estimate = estimate_run(scene);
  EXPECT_EQ(estimate.particle_steps, result.particle_steps);
  EXPECT_DOUBLE_EQ(estimate.simulated_seconds, 0.3);
  const auto liquid_steps = std::ranges::count_if(result.bed.time, [](double time) { return time > 0.0; });
  EXPECT_EQ(estimate.cell_steps, estimate.liquid_cells * liquid_steps);
}

TEST(FormatDuration, ChoosesTheUnit) {
  EXPECT_EQ(format_duration(0.04), "0.0 s");
  EXPECT_EQ(format_duration(4.52), "4.5 s");
  EXPECT_EQ(format_duration(45.2), "45 s");
  EXPECT_EQ(format_duration(185.0), "3 min 05 s");
  EXPECT_EQ(format_duration(7800.0), "2 h 10 min");
  EXPECT_EQ(format_duration(-1.0), "0.0 s");
  EXPECT_EQ(format_duration(std::numeric_limits<double>::quiet_NaN()), "?");
}

}  // namespace
}  // namespace slfb
