// All forces along z on spheres and liquid together add up to zero, whatever a scene chooses.
#include "solver/coupling/force_balance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"

namespace slfb {
namespace {

struct Option {
  std::string name;
  std::function<void(Scene&)> choose;
};

Scene small_box() {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.02, 0.02};
  scene.geometry.height = 0.2;
  scene.liquid = {998.2, 1e-3, 0.08};
  scene.fluid.cells_across = 3;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230, 40}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  Stage settle, fluidise;
  settle.kind = StageKind::settle;
  settle.duration = 0.2;
  fluidise.kind = StageKind::fluidise;
  fluidise.duration = 0.5;
  scene.stages = {settle, fluidise};
  return scene;
}

std::vector<Option> options() {
  std::vector<Option> list{{"default", [](Scene&) {}}};
  const auto add = [&](const std::string& name, std::function<void(Scene&)> choose) {
    list.push_back({name, std::move(choose)});
  };
  add("one_dimensional", [](Scene& s) { s.fluid.tier = FluidTier::one_dimensional; });
  add("slip", [](Scene& s) { s.fluid.wall = LateralBoundary::slip; });
  add("periodic", [](Scene& s) { s.fluid.wall = LateralBoundary::periodic; });
  add("cylinder", [](Scene& s) {
    s.geometry.shape = Shape::cylinder;
    s.geometry.diameter = 0.0225;
  });
  for (const auto& [name, scheme] : {std::pair{"upwind", ConvectionScheme::upwind},
                                     {"central", ConvectionScheme::central},
                                     {"muscl", ConvectionScheme::muscl}})
    add(name, [scheme = scheme](Scene& s) { s.fluid.convection = scheme; });
  add("simple", [](Scene& s) { s.fluid.pressure_velocity = PressureVelocity::simple; });
  add("second_order", [](Scene& s) { s.fluid.time_scheme = TimeScheme::second_order; });
  add("second_order_simple", [](Scene& s) {
    s.fluid.time_scheme = TimeScheme::second_order;
    s.fluid.pressure_velocity = PressureVelocity::simple;
    s.fluid.simple_tolerance = 1e-9;
  });
  add("second_order_one_dimensional", [](Scene& s) {
    s.fluid.time_scheme = TimeScheme::second_order;
    s.fluid.tier = FluidTier::one_dimensional;
  });
  for (const auto& [name, integrator] : {std::pair{"velocity_verlet", Integrator::velocity_verlet},
                                         {"position_verlet", Integrator::position_verlet},
                                         {"gear", Integrator::gear}})
    add(name, [integrator = integrator](Scene& s) { s.contact.integrator = integrator; });
  add("elastic_plastic_rolling", [](Scene& s) {
    s.contact.rolling_friction = 0.05;
    s.contact.rolling_model = RollingModel::elastic_plastic;
  });
  for (const auto& [name, scheme] : {std::pair{"centroid", VoidFractionScheme::centroid},
                                     {"particle_meshing", VoidFractionScheme::particle_meshing}})
    add(name, [scheme = scheme](Scene& s) { s.coupling.void_fraction = scheme; });
  add("void_fraction_interval", [](Scene& s) { s.coupling.void_fraction_interval = 2e-3; });
  for (const auto& [name, exchange] :
       {std::pair{"explicit", MomentumExchange::explicit_in_time}, {"implicit", MomentumExchange::implicit}})
    add(name, [exchange = exchange](Scene& s) { s.coupling.exchange = exchange; });
  for (const auto& [name, interpolation] :
       {std::pair{"gradient", Interpolation::gradient}, {"trilinear", Interpolation::trilinear}})
    add(name, [interpolation = interpolation](Scene& s) { s.coupling.interpolation = interpolation; });
  add("added_mass", [](Scene& s) { s.coupling.added_mass = 0.5; });
  add("added_mass_velocity_verlet", [](Scene& s) {
    s.coupling.added_mass = 0.5;
    s.contact.integrator = Integrator::velocity_verlet;
  });
  add("saffman_lift", [](Scene& s) { s.coupling.saffman_lift = true; });
  add("magnus_lift", [](Scene& s) { s.coupling.magnus_lift = true; });
  add("basset_history", [](Scene& s) { s.coupling.basset_history = true; });
  add("lubrication", [](Scene& s) { s.coupling.lubrication_range = 1e-4; });
  add("disturbance_correction", [](Scene& s) { s.coupling.disturbance_correction = true; });
  add("own_volume_counted", [](Scene& s) { s.coupling.own_volume = OwnVolume::counted; });
  add("drag_times_voidage", [](Scene& s) {
    s.coupling.drag_times_voidage = true;
    s.liquid.superficial_velocity = 0.1;
  });
  add("smoothing", [](Scene& s) { s.coupling.smoothing_length = 0.01; });
  add("outlet_removes", [](Scene& s) {
    s.outlet.rule = OutletRule::remove;
    s.liquid.superficial_velocity = 0.6;
  });
  return list;
}

class ForceBalance : public testing::TestWithParam<Option> {};

TEST_P(ForceBalance, ClosesInEveryStep) {
  Scene scene = small_box();
  GetParam().choose(scene);
  validate_scene(scene);
  RunOptions run_options;
  run_options.directory = std::filesystem::temp_directory_path() / "slfb_force_balance_test" / GetParam().name;
  std::filesystem::remove_all(run_options.directory);
  const BedSeries bed = run_scene(scene, run_options).result.bed;
  ASSERT_GT(bed.balance_residual.size(), 10u);
  const double largest = *std::max_element(bed.balance_residual.begin(), bed.balance_residual.end());
  RecordProperty("largest_residual", std::to_string(largest));
  if (coupling::imbalance_of_forces(scene).empty())
    EXPECT_LT(largest, 1e-6);
  else
    EXPECT_GT(largest, 1e-6) << "the exception that is told to users is none";
}

INSTANTIATE_TEST_SUITE_P(Options, ForceBalance, testing::ValuesIn(options()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace slfb
