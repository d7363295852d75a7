// Where the spheres of the bed are at the start, and what they do without the liquid.
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "correlations/materials.hpp"
#include "solver/dem/packing.hpp"
#include "solver/run/model.hpp"
#include "solver/run/simulation.hpp"
#include "solver/scene/scene_problems.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

Scene column(Arrangement arrangement) {
  Scene scene;
  scene.start.arrangement = arrangement;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.2;
  scene.liquid = {998.2, 1e-3, 0.0};
  scene.fluid.tier = FluidTier::quiescent;
  scene.fluid.cell_height = 0.01;
  scene.fluid.time_step = 1e-4;
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.species = {{"glass", 0.005, 2230, 250}};
  Stage settle;
  settle.kind = StageKind::settle;
  settle.duration = 0.4;
  scene.stages = {settle};
  return scene;
}

/// Columns of each kind: cylinder, box and periodic box, the last with two sizes.
std::vector<Scene> columns(Arrangement arrangement) {
  std::vector<Scene> scenes(3, column(arrangement));
  for (std::size_t k = 1; k < 3; ++k) {
    scenes[k].geometry.shape = Shape::box;
    scenes[k].geometry.width = {0.03, 0.02};
  }
  scenes[2].fluid.wall = LateralBoundary::periodic;
  scenes[2].geometry.height = 0.4;
  scenes[2].species = {{"small", 0.002, 2230, 400}, {"large", 0.006, 2230, 60}};
  return scenes;
}

class StartPositions : public testing::TestWithParam<Arrangement> {};

TEST_P(StartPositions, LieInsideTheColumnWithoutOverlap) {
  for (const Scene& scene : columns(GetParam())) {
    const auto spheres = dem::start_positions(scene);
    const bool periodic = scene.fluid.wall == LateralBoundary::periodic;
    std::vector<std::int64_t> count(scene.species.size(), 0);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const auto& a = spheres[i].centre;
      const auto radius_of = [&](const dem::PlacedSphere& sphere) {
        return 0.5 * scene.species[static_cast<std::size_t>(sphere.species)].diameter;
      };
      const double radius = radius_of(spheres[i]);
      ++count[static_cast<std::size_t>(spheres[i].species)];
      EXPECT_GE(a[2], radius);
      EXPECT_LE(a[2], scene.geometry.height - radius);
      if (scene.geometry.shape == Shape::cylinder)
        EXPECT_LE(std::hypot(a[0], a[1]) + radius, 0.5 * scene.geometry.diameter);
      else
        for (std::size_t axis = 0; axis < 2; ++axis)
          EXPECT_LE(std::abs(a[axis]) + (periodic ? 0.0 : radius), 0.5 * scene.geometry.width[axis]);
      for (std::size_t j = 0; j < i; ++j) {
        double squared = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          double d = a[axis] - spheres[j].centre[axis];
          if (periodic && axis < 2) d = std::remainder(d, scene.geometry.width[axis]);
          squared += d * d;
        }
        EXPECT_GE(std::sqrt(squared), (radius + radius_of(spheres[j])) * (1.0 - 1e-12));
      }
    }
    for (std::size_t s = 0; s < count.size(); ++s) EXPECT_EQ(count[s], scene.species[s].count);
  }
}

TEST_P(StartPositions, AreThoseOfTheSeed) {
  Scene scene = column(GetParam());
  const auto first = dem::start_positions(scene), again = dem::start_positions(scene);
  scene.seed = 2;
  const auto other = dem::start_positions(scene);
  ASSERT_EQ(first.size(), 250U);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].centre, again[i].centre);
    moved += first[i].centre != other[i].centre ? 1 : 0;
  }
  EXPECT_EQ(moved, first.size());
}

INSTANTIATE_TEST_SUITE_P(Arrangements, StartPositions,
                         testing::Values(Arrangement::lattice, Arrangement::random, Arrangement::random_close));

/// Kolmogorov-Smirnov distance of the spheres' heights from an even spread over the column, times √n.
double distance_from_even_spread(const Scene& scene) {
  std::vector<double> heights;
  const double radius = 0.5 * scene.species.front().diameter;
  for (const auto& sphere : dem::start_positions(scene))
    heights.push_back((sphere.centre[2] - radius) / (scene.geometry.height - 2.0 * radius));
  std::ranges::sort(heights);
  double distance = 0.0;
  const auto n = static_cast<double>(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto k = static_cast<double>(i);
    distance = std::max({distance, std::abs(heights[i] - k / n), std::abs(heights[i] - (k + 1.0) / n)});
  }
  return distance * std::sqrt(n);
}

// 3600 spheres of 5 mm in a column of 50 mm and 1 m, 12 % of it.
TEST(StartPositions, AtRandomAreSpreadEvenlyOverTheHeight) {
  Scene scene = column(Arrangement::random);
  scene.geometry.diameter = 0.05;
  scene.geometry.height = 1.0;
  scene.species.front().count = 3600;
  constexpr double one_per_cent_level = 1.63;
  for (const std::uint64_t seed : {1, 2, 3}) {
    scene.seed = seed;
    EXPECT_LT(distance_from_even_spread(scene), one_per_cent_level) << "seed " << seed;
  }
  scene.start.arrangement = Arrangement::lattice;
  EXPECT_GT(distance_from_even_spread(scene), 10.0 * one_per_cent_level) << "the test cannot fail";
}

TEST(StartPositions, RandomCloseFillsTheLowerPartWithThreeTenthsOfSolids) {
  Scene scene = column(Arrangement::random_close);
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.05, 0.05};
  scene.fluid.wall = LateralBoundary::periodic;
  scene.species.front().count = 2000;
  double top = 0.0;
  for (const auto& sphere : dem::start_positions(scene)) top = std::max(top, sphere.centre[2] + 0.0025);
  const double volume = 2000.0 * scene.species.front().volume();
  // The highest of so many spheres all but touches the height that is filled.
  EXPECT_NEAR(volume / (top * scene.geometry.cross_section()), 0.30, 0.003);
}

TEST(StartPositions, ThatAreNotFoundAreAnErrorThatCountsThem) {
  Scene scene = column(Arrangement::random);
  scene.geometry.height = 0.062;  // 0.373 of it solid
  try {
    dem::start_positions(scene);
    FAIL() << "random addition does not get as far as this";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("of 250 spheres find a place at random"), std::string::npos) << message;
  }
}

/// Whether all lie inside a cylinder without overlap.
void expect_free_in_cylinder(const Scene& scene, const std::vector<dem::PlacedSphere>& spheres) {
  const auto radius_of = [&](const dem::PlacedSphere& sphere) {
    return 0.5 * scene.species[static_cast<std::size_t>(sphere.species)].diameter;
  };
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto& a = spheres[i].centre;
    EXPECT_LE(std::hypot(a[0], a[1]) + radius_of(spheres[i]), 0.5 * scene.geometry.diameter);
    EXPECT_GE(a[2], radius_of(spheres[i]));
    EXPECT_LE(a[2] + radius_of(spheres[i]), scene.geometry.height);
    for (std::size_t j = 0; j < i; ++j) {
      const auto& b = spheres[j].centre;
      EXPECT_GE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), radius_of(spheres[i]) + radius_of(spheres[j]));
    }
  }
}

// Between one and three spheres across, where a square of places reaches beyond the wall or has no room at all.
TEST(StartPositions, AreFoundInNarrowTubes) {
  for (double ratio = 1.02; ratio < 3.0; ratio += 0.02) {
    Scene scene = column(Arrangement::lattice);
    scene.geometry.diameter = ratio * 0.005;
    scene.geometry.height = 0.5;
    scene.species.front().count = 10;
    const auto spheres = dem::start_positions(scene);
    ASSERT_EQ(spheres.size(), 10U) << ratio;
    expect_free_in_cylinder(scene, spheres);
  }
  for (double ratio = 1.02; ratio < 1.2; ratio += 0.02) {
    Scene box = column(Arrangement::lattice);
    box.geometry.shape = Shape::box;
    box.geometry.width = {0.03, ratio * 0.005};
    box.species.front().count = 10;
    for (const auto& sphere : dem::start_positions(box))
      EXPECT_LE(std::abs(sphere.centre[1]) + 0.0025, 0.5 * box.geometry.width[1]) << ratio;
  }
}

// With a place for the largest of them each, they would need a column six times as high.
TEST(StartPositions, SmallSpheresShareThePlaceOfALargeOne) {
  Scene scene = column(Arrangement::lattice);
  scene.geometry.height = 0.09;
  scene.species = {{"small", 0.0025, 2230, 1000}, {"large", 0.006, 2230, 20}};
  const auto spheres = dem::start_positions(scene);
  ASSERT_EQ(spheres.size(), 1020U);
  expect_free_in_cylinder(scene, spheres);
  const auto large = std::ranges::count(spheres, 1, &dem::PlacedSphere::species);
  EXPECT_EQ(large, 20);
}

// --- columns without a sphere, and beds that float -------------------------------------------------------------------

Scene periodic_box(double density) {
  Scene scene = column(Arrangement::lattice);
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.025, 0.025};
  scene.geometry.height = 0.15;
  scene.fluid.wall = LateralBoundary::periodic;
  scene.species = {{"glass", 0.005, density, 100}};
  return scene;
}

RunResult run_of(const Scene& scene) {
  const Folder folder;
  RunOptions options;
  options.directory = folder.path();
  return run_scene(scene, options).result;
}

// The sphere is taken out at the bottom: the column is empty then, and the run goes on.
TEST(EmptyColumn, WithPeriodicSidesEndsItsDrops) {
  Scene scene = periodic_box(7800);
  scene.species.front().count = 0;
  scene.stages.front().kind = StageKind::drop;
  scene.stages.front().species = "glass";
  scene.stages.front().release_height = 0.04;
  scene.stages.front().relaxation = 0.01;
  scene.stages.front().duration = 1.0;
  scene.stages.front().repetitions = 2;
  const RunResult result = run_of(scene);
  ASSERT_EQ(result.drops.size(), 2U);
  EXPECT_GT(result.drops[0].bottom_time, 0.0);
  EXPECT_EQ(result.drops[1].bottom_time, result.drops[0].bottom_time);
}

// Upside down, the forces are those of a bed with the opposite buoyant weight: it packs as that does, under the lid.
TEST(FloatingBed, HangsUnderTheLid) {
  Scene light = periodic_box(600.0), heavy = periodic_box(2.0 * 998.2 - 600.0);
  light.stages.front().duration = heavy.stages.front().duration = 1.5;
  const RunResult floats = run_of(light), sinks = run_of(heavy);
  EXPECT_NEAR(floats.packed_voidage, sinks.packed_voidage, 0.03);
  EXPECT_NEAR(floats.packed_height, 0.019, 0.001);
}

// --- settling without the liquid -------------------------------------------------------------------------------------

// With a range of lubrication that would slow it down, and the floor within it.
TEST(DrySettling, ASphereFallsWithGravityAlone) {
  Scene scene = column(Arrangement::lattice);
  scene.species.front().count = 1;
  scene.geometry.height = 0.006;
  scene.coupling.lubrication_range = 1e-3;
  scene.coupling.added_mass = 0.5;
  scene.stages.front().dry = true;
  simulation::Model model(scene, 1);
  model.fill();
  const double start = model.particles().position.z[0];
  constexpr int steps = 50;
  for (int k = 0; k < steps; ++k) model.advance(simulation::Surroundings::nothing);
  const double dt = scene.contact.time_step, time = steps * dt;
  ASSERT_GT(model.particles().position.z[0], 0.0025) << "it has met the floor";
  EXPECT_NEAR(model.particles().velocity.z[0], -gravitational_acceleration * time, 1e-13);
  // Symplectic Euler: the sum of the speeds, each that of the end of its step.
  EXPECT_NEAR(start - model.particles().position.z[0], 0.5 * gravitational_acceleration * time * (time + dt), 1e-13);

  model.advance(simulation::Surroundings::resting_liquid);
  EXPECT_GT(model.particles().velocity.z[0], -gravitational_acceleration * (time + 0.9 * dt))
      << "the liquid has entered";
}

// Spheres that fall onto the bed push it together; those that sink do not. Three beds of each kind.
TEST(DrySettling, AtRandomMakesADenserBedThanALatticeInTheLiquid) {
  double highest_dry = 0.0, lowest_wet = 1.0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    Scene dry = column(Arrangement::random), wet = column(Arrangement::lattice);
    dry.seed = wet.seed = seed;
    dry.stages.front().dry = true;
    dry.stages.front().duration = 0.6;
    wet.stages.front().duration = 1.0;
    highest_dry = std::max(highest_dry, run_of(dry).packed_voidage);
    lowest_wet = std::min(lowest_wet, run_of(wet).packed_voidage);
  }
  EXPECT_LT(highest_dry, lowest_wet - 0.005);
}

TEST(DrySettling, GoesOnAfterAStopAsIfNothingHadHappened) {
  Scene scene = column(Arrangement::random_close);
  scene.stages.front().dry = true;
  scene.stages.front().duration = 0.2;
  const RunResult whole = run_of(scene);
  const Folder folder;
  std::atomic<bool> stop = false;
  RunOptions options;
  options.directory = folder.path();
  options.stop = &stop;
  options.progress_interval = 0.0;
  options.progress = [&](const Progress& progress) { stop = progress.simulated_seconds > 0.1; };
  ASSERT_EQ(run_scene(scene, options).status, RunStatus::interrupted);
  options.stop = nullptr;
  EXPECT_EQ(run_scene(scene, options).result.packed_height, whole.packed_height);
}

/// What a run warns of.
std::string warnings_of(const Scene& scene) {
  std::ostringstream text;
  const auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(text);
  auto& sinks = spdlog::default_logger()->sinks();
  sinks.push_back(sink);
  run_of(scene);
  sinks.pop_back();
  return text.str();
}

// A sphere of radius r that strikes the floor at v presses it in by v √(m/k): half its radius here.
TEST(DeepOverlap, IsToldWithItsPlaceAndTheStiffnessThatHelps) {
  Scene scene = column(Arrangement::random);
  scene.species.front().count = 1;
  scene.contact.restitution = 1.0;
  scene.stages.front().dry = true;
  scene.stages.front().duration = 0.25;
  const double start = dem::start_positions(scene).front().centre[2] - 0.0025;
  ASSERT_GT(start, 0.05) << "the weight at rest must be small against the impact";
  const double speed = std::sqrt(2.0 * gravitational_acceleration * start);
  scene.contact.stiffness = scene.species.front().mass() * std::pow(speed / (0.5 * 0.0025), 2);
  const std::string warning = warnings_of(scene);
  EXPECT_NE(warning.find("sphere 0 overlaps the distributor by 0."), std::string::npos) << warning;
  scene.contact.stiffness *= 10.0;
  EXPECT_EQ(warnings_of(scene).find("overlaps"), std::string::npos) << warnings_of(scene);
}

TEST(Settling, WarnsOfABedThatStillMoves) {
  Scene scene = column(Arrangement::random_close);
  scene.stages.front().dry = true;
  scene.stages.front().duration = 0.05;
  EXPECT_NE(warnings_of(scene).find("the spheres still move"), std::string::npos);
  scene.stages.front().duration = 0.6;
  EXPECT_EQ(warnings_of(scene), "");
}

}  // namespace
}  // namespace slfb
