// Columns that lean: gravity acts at an angle to their axis.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "solver/laws/scene_file.hpp"
#include "solver/laws/scene_remarks.hpp"
#include "solver/run/model.hpp"
#include "solver/run/simulation.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

using simulation::Model, simulation::Surroundings;

constexpr double g = 9.81;
double in_radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// A box of glass spheres of 5 mm that settle in water at rest.
Scene box(double inclination, std::int64_t spheres) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.05, 0.025};
  scene.geometry.height = 0.4;
  scene.geometry.inclination = inclination;
  scene.liquid = {998.2, 1e-3, 0.0};
  scene.fluid.tier = FluidTier::quiescent;
  scene.fluid.wall = LateralBoundary::slip;
  scene.fluid.cells_across = 8;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = scene.contact.time_step = 1e-4;
  scene.contact.stiffness = 1e3;
  scene.contact.sliding_friction = 0.0;
  scene.species = {{"glass", 0.005, 2230, spheres}};
  Stage settle;
  settle.kind = StageKind::settle;
  settle.duration = 0.3;
  scene.stages = {settle};
  return scene;
}

/// Acceleration along the lower wall of a sphere that starts at rest beside it [m/s²].
double acceleration_on_wall(double inclination, double friction) {
  Scene scene = box(inclination, 0);
  scene.geometry.width[0] = 0.00505;
  scene.contact.sliding_friction = friction;
  scene.contact.restitution = 0.3;
  scene.contact.time_step = 2e-5;
  Model model(scene, 1);
  model.release(scene.species[0], 0.35);
  const auto speed_after = [&](int steps) {
    for (int k = 0; k < steps; ++k) model.advance(Surroundings::nothing);
    return -model.particles().velocity.z[0];
  };
  constexpr int steps = 1000;
  const double early = speed_after(steps), late = speed_after(steps);
  EXPECT_NEAR(model.particles().position.x[0], 2.5e-5, 3e-6) << "it lies on the wall that gravity pulls it to";
  EXPECT_GT(model.particles().position.z[0], 0.01) << "it has met the bottom";
  return (late - early) / (steps * scene.fluid.time_step);
}

// Coulomb: a = g (cos φ − μ sin φ) on a wall at the angle φ to the vertical. A sphere rolls without sliding where μ is
// more than 2/7 of cot φ (0.165 at 60 degrees), at 5/7 g cos φ: its moment of inertia is 2/5 m r².
TEST(InclinedColumn, ASphereSlidesOrRollsDownTheLowerWall) {
  for (const double angle : {30.0, 60.0}) {
    const double across = g * std::sin(in_radians(angle)), along = g * std::cos(in_radians(angle));
    EXPECT_NEAR(acceleration_on_wall(angle, 0.0), along, 1e-3 * along) << angle;
    EXPECT_NEAR(acceleration_on_wall(angle, 0.1), along - 0.1 * across, 5e-3 * along) << angle;
    EXPECT_NEAR(acceleration_on_wall(angle, 0.9), 5.0 / 7.0 * along, 5e-3 * along) << angle;
  }
}

// Far from walls a sphere does not know how the column leans: it falls along gravity, as fast as in an upright one.
TEST(InclinedColumn, ASphereInWaterFallsVertically) {
  const auto velocity = [](double angle) {
    Scene scene = box(angle, 0);
    scene.geometry.width = {0.2, 0.2};
    scene.species[0].diameter = 0.002;
    Model model(scene, 1);
    model.release(scene.species[0], 0.3);
    for (int k = 0; k < 3000; ++k) model.advance(Surroundings::resting_liquid);
    return model.particles().velocity.at(0);
  };
  const double fall = -velocity(0.0)[2];
  EXPECT_EQ(velocity(0.0)[0], 0.0);
  for (const double angle : {10.0, 45.0}) {
    const auto v = velocity(angle);
    EXPECT_NEAR(v[0], fall * std::sin(in_radians(angle)), 1e-9 * fall);
    EXPECT_EQ(v[1], 0.0);
    EXPECT_NEAR(v[2], -fall * std::cos(in_radians(angle)), 1e-9 * fall);
  }
}

// The liquid carries the part of the bed's buoyant weight that is along the axis; smooth walls bear the other.
TEST(InclinedColumn, ThePressureDropCarriesTheWeightAlongTheAxis) {
  for (const FluidTier tier : {FluidTier::one_dimensional, FluidTier::three_dimensional})
    for (const double angle : {0.0, 25.0}) {
      SCOPED_TRACE(fmt::format("tier {}, {} degrees", static_cast<int>(tier), angle));
      Scene scene = box(angle, 60);
      scene.fluid.tier = tier;
      scene.geometry.width = {0.025, 0.025};
      scene.fluid.cells_across = 4;
      scene.fluid.time_step = 1e-3;
      scene.fluid.inlet_velocity = InletVelocity::superficial;
      scene.liquid.superficial_velocity = 0.08;
      Stage fluidise;
      fluidise.kind = StageKind::fluidise;
      fluidise.duration = 2.0;
      scene.stages.push_back(fluidise);
      validate_scene(scene);
      const Folder folder;
      const BedSeries bed = run_scene(scene, {.directory = folder.path()}).result.bed;
      const double buoyant = 60.0 * scene.species[0].volume() * (2230.0 - 998.2) * g;
      const auto mean = [](const std::vector<double>& values) {
        const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        return std::accumulate(half, values.end(), 0.0) / static_cast<double>(values.end() - half);
      };
      EXPECT_NEAR(bed.buoyant_weight.back(), -buoyant * std::cos(in_radians(angle)), 1e-12 * buoyant);
      EXPECT_LT(std::ranges::max(bed.balance_residual), 1e-6);
      EXPECT_NEAR(mean(bed.wall_force), 0.0, 1e-9 * buoyant);
      EXPECT_NEAR(mean(bed.pressure_drop) * scene.geometry.cross_section() + mean(bed.bottom_force),
                  buoyant * std::cos(in_radians(angle)), 0.02 * buoyant);
      // A liquid of one dimension may hold a leaning bed as a plug.
      if (tier == FluidTier::three_dimensional) {
        EXPECT_LT(mean(bed.bottom_force), 0.1 * buoyant) << "it is fluidised";
      }
    }
}

// A settled bed without friction stands on the bottom with the part of its buoyant weight along the axis, and its
// surface is level: over a width w it is higher by w tan φ at the lower wall, so that its centre of mass lies w² tan
// φ/(12 h) from the axis. Layers of spheres order themselves along the walls, hence the wide margin of the latter.
TEST(InclinedColumn, ASettledBedStandsOnTheBottomAndLeansOnTheLowerWall) {
  constexpr double angle = 15.0;
  constexpr int spheres = 350;
  const Scene scene = box(angle, spheres);
  Model model(scene, 1);
  model.fill();
  for (int k = 0; k < 15000; ++k) model.advance(Surroundings::resting_liquid);
  double bottom = 0.0;
  constexpr int steps = 500;
  for (int k = 0; k < steps; ++k) {
    model.advance(Surroundings::resting_liquid);
    bottom += model.engine().mean_vertical_wall_forces().bottom / steps;
  }
  const double buoyant = spheres * scene.species[0].volume() * (2230.0 - 998.2) * g;
  EXPECT_NEAR(bottom, buoyant * std::cos(in_radians(angle)), 2e-3 * buoyant);
  const auto mean = [](const auto& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  const double x = mean(model.particles().position.x), height = 2.0 * mean(model.particles().position.z);
  const double width = scene.geometry.width[0];
  EXPECT_NEAR(x, width * width * std::tan(in_radians(angle)) / (12.0 * height), 0.5 * x);
}

std::string refusal(Scene scene) {
  try {
    validate_scene(scene);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "valid";
}

TEST(InclinedColumn, IsAKeyThatUprightScenesDoNotHave) {
  const Scene upright = box(0.0, 20);
  EXPECT_EQ(canonical_toml(upright).find("inclination"), std::string::npos);
  const auto with = [&](const std::string& value) {
    return parse_scene(canonical_toml(upright), "scene.toml", {"geometry.inclination=" + value});
  };
  EXPECT_EQ(scene_hash(with("0 degree")), scene_hash(upright));
  EXPECT_NE(scene_hash(with("10 degree")), scene_hash(upright));
  EXPECT_EQ(with("10 degree").geometry.inclination, 10.0);
  EXPECT_EQ(with("10").geometry.inclination, 10.0);
  EXPECT_NEAR(with("0.5 rad").geometry.inclination, 28.6478897565, 1e-9);
  EXPECT_EQ(canonical_toml(parse_scene(canonical_toml(with("10")), "again")), canonical_toml(with("10")));
  EXPECT_THROW(with("90 degree"), SceneError);
  EXPECT_THROW(with("-1 degree"), SceneError);
}

TEST(InclinedColumn, IsRefusedWhereItMeansNothing) {
  Scene scene = box(10.0, 20);
  EXPECT_EQ(refusal(scene), "valid");
  scene.fluid.wall = LateralBoundary::periodic;
  EXPECT_NE(refusal(scene).find("slide through periodic sides"), std::string::npos) << refusal(scene);
  scene = box(10.0, 0);
  scene.geometry.shape = Shape::cylinder;
  scene.geometry.diameter = 0.05;
  scene.coupling.wall_retardation = "haberman-sayre-1958";
  scene.stages[0].kind = StageKind::drop;
  scene.stages[0].species = "glass";
  scene.stages[0].release_height = 0.3;
  EXPECT_NE(refusal(scene).find("for a sphere on the axis"), std::string::npos) << refusal(scene);
  // A liquid of one dimension has no way to circulate, as that of an inclined column does; it is said.
  Scene flat = box(10.0, 20);
  flat.fluid.tier = FluidTier::one_dimensional;
  const auto remarks = remarks_on(flat);
  EXPECT_TRUE(std::ranges::any_of(remarks, [](const auto& one) { return one.starts_with("geometry.inclination"); }));
}

}  // namespace
}  // namespace slfb
