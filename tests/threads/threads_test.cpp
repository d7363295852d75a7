// Threads share the work of a step and nothing else: results are bitwise those of one thread, and the thread sanitizer
// finds no race (make tsan).
#include <gtest/gtest.h>

#include <string>

#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

/// A small bed into which a sphere is dropped, with every force of the suite. More than one block of 256 spheres.
Scene bed(FluidTier tier) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.025, 0.025};
  scene.geometry.height = 0.25;
  scene.liquid = {998.2, 1e-3, 0.08};
  scene.fluid.tier = tier;
  scene.fluid.cells_across = 4;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.contact.rolling_friction = 0.01;
  scene.coupling.added_mass = 0.5;
  scene.coupling.saffman_lift = scene.coupling.magnus_lift = scene.coupling.basset_history = true;
  scene.coupling.lubrication_range = 2.5e-4;
  scene.species = {{"glass", 0.003, 2230, 600}, {"steel", 0.006, 7800, 0}};
  Stage settle, fluidise, drop;
  settle.kind = StageKind::settle;
  fluidise.kind = StageKind::fluidise;
  drop.kind = StageKind::drop;
  settle.duration = fluidise.duration = 0.02;
  drop.duration = 0.05;
  drop.species = "steel";
  drop.release_height = 0.24;
  scene.stages = {settle, fluidise, drop};
  scene.recording.bed_interval = 2e-3;
  return scene;
}

RunResult result_with(const Scene& scene, int threads) {
  const Folder folder;
  return run_scene(scene, {.threads = threads, .directory = folder.path()}).result;
}

class Threads : public testing::TestWithParam<FluidTier> {};

TEST_P(Threads, ChangeNoBit) {
  const Scene scene = bed(GetParam());
  validate_scene(scene);
  const RunResult one = result_with(scene, 1);
  ASSERT_FALSE(one.drops.empty());
  ASSERT_FALSE(one.bed.time.empty() && GetParam() != FluidTier::quiescent);
  for (const int threads : {2, 3}) {
    const RunResult more = result_with(scene, threads);
    EXPECT_EQ(more.bed.pressure_drop, one.bed.pressure_drop);
    EXPECT_EQ(more.bed.centre_of_mass_height, one.bed.centre_of_mass_height);
    EXPECT_EQ(more.bed.fluctuating_energy, one.bed.fluctuating_energy);
    EXPECT_EQ(more.drops.at(0).z, one.drops.at(0).z);
    EXPECT_EQ(more.drops.at(0).drag_force_z, one.drops.at(0).drag_force_z);
  }
}

INSTANTIATE_TEST_SUITE_P(Tiers, Threads,
                         testing::Values(FluidTier::quiescent, FluidTier::one_dimensional,
                                         FluidTier::three_dimensional),
                         [](const auto& test) {
                           return std::string(test.param == FluidTier::quiescent         ? "quiescent"
                                              : test.param == FluidTier::one_dimensional ? "one_dimensional"
                                                                                         : "three_dimensional");
                         });

}  // namespace
}  // namespace slfb
