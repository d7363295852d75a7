#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <vector>

#include "experiments/runs/run_estimate.hpp"
#include "solver/io/run_result.hpp"
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

// 3601 spheres: 1 s of settling without liquid, then 4 s and three falls of 2 s with 0.5 s between them.
TEST(RunEstimate, CountsStepsByWhatTheSpheresDo) {
  Scene scene = synthetic::scene(0.2);
  scene.stages.front().dry = true;
  const RunEstimate loose = estimate_run(scene, 2.0);
  EXPECT_NEAR(static_cast<double>(loose.dry_steps), 3601 * 1.0 / 5e-5, 1.0);
  EXPECT_EQ(loose.packed_steps, 0);
  EXPECT_NEAR(static_cast<double>(loose.exchange_steps), 3601 * 11.5 / 1e-3, 1.0);
  // Far below minimum fluidisation all that follows is of a packed bed.
  scene.liquid.superficial_velocity = 0.01;
  const RunEstimate packed = estimate_run(scene, 2.0);
  EXPECT_NEAR(static_cast<double>(packed.packed_steps), 3601 * 11.5 / 5e-5, 1.0);
  EXPECT_EQ(packed.particle_steps, loose.particle_steps);
  EXPECT_GT(packed.core_seconds, loose.core_seconds);
}

TEST(RunEstimate, CountsWhatChoicesCostBeside) {
  Scene scene = synthetic::scene(0.1);
  const RunEstimate plain = estimate_run(scene);
  EXPECT_EQ(plain.piece_steps + plain.simple_steps + plain.disturbance_steps + plain.added_mass_steps, 0);
  scene.coupling.void_fraction = VoidFractionScheme::particle_meshing;
  scene.coupling.meshing_pieces = 1214;
  const RunEstimate meshing = estimate_run(scene);
  // Each sphere's pieces are put into cells in each liquid step, or in every fourth.
  EXPECT_EQ(meshing.piece_steps, 1214 * plain.exchange_steps);
  scene.coupling.void_fraction_interval = 4.0 * scene.fluid.time_step;
  EXPECT_NEAR(static_cast<double>(estimate_run(scene).piece_steps), 0.25 * static_cast<double>(meshing.piece_steps),
              1.0);
  scene.fluid.pressure_velocity = PressureVelocity::simple;
  EXPECT_EQ(estimate_run(scene).simple_steps, plain.cell_steps);
  EXPECT_GT(meshing.core_seconds, plain.core_seconds);
}

/// Estimated over measured CPU time of every fourth published run of one machine and day, with the falls as long as
/// they were.
std::vector<double> estimated_over_measured() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "reports/published"))
    if (entry.path().extension() == ".h5") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < files.size(); i += 4) {
    const RunResult result = load_result(files[i]);
    if (!result.date.starts_with("2026-11-30") || result.threads != 1) continue;
    const Scene scene = parse_scene(result.scene_text, files[i].string());
    const double without_falls = estimate_run(scene, 0.0).simulated_seconds;
    int falls = 0;
    for (const Stage& stage : scene.stages)
      if (stage.kind == StageKind::drop) falls += stage.repetitions;
    const double fall = falls == 0 ? 0.0 : (result.simulated_seconds - without_falls) / falls;
    ratios.push_back(estimate_run(scene, fall).core_seconds / result.cpu_seconds);
  }
  return ratios;
}

// The measured times scatter by themselves, as other work shared the machine: nine of ten within 30 %, none twice off.
TEST(RunEstimate, AgreesWithTheCpuTimesOfPublishedRuns) {
  const std::vector<double> ratios = estimated_over_measured();
  ASSERT_GT(ratios.size(), 80U);
  const auto near = std::ranges::count_if(ratios, [](double ratio) { return ratio > 0.7 && ratio < 1.3; });
  EXPECT_GE(static_cast<double>(near), 0.9 * static_cast<double>(ratios.size())) << near << " of " << ratios.size();
  EXPECT_GT(std::ranges::min(ratios), 0.5);
  EXPECT_LT(std::ranges::max(ratios), 2.0);
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
