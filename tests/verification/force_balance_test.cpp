// All forces along z on spheres and liquid together add up to zero, whatever a scene chooses.
#include "solver/coupling/force_balance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
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
    add(name, [scheme = scheme](Scene& s) {
      s.coupling.void_fraction = scheme;
      s.fluid.cells_across = 2;  // room for all centres that may lie in one cell
      s.fluid.cell_height = 0.0125;
      s.fluid.pressure_tolerance = 1e-8;  // whole spheres jump: what is left of continuity is momentum
    });
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
  add("inlet_superficial", [](Scene& s) { s.fluid.inlet_velocity = InletVelocity::superficial; });
  add("smoothing", [](Scene& s) { s.coupling.smoothing_length = 0.01; });
  add("outlet_removes", [](Scene& s) {
    s.outlet.rule = OutletRule::remove;
    s.fluid.pressure_tolerance = 1e-8;
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

double mean_of_second_half(const std::vector<double>& values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  return std::accumulate(half, values.end(), 0.0) / static_cast<double>(values.end() - half);
}

/// Heavy spheres in a fast liquid without side walls: alumina of Lethe's example of a liquid-solid fluidised bed.
Scene heavy_bed(FluidTier tier, InletVelocity inlet) {
  Scene scene = small_box();
  scene.geometry.width = {0.018, 0.018};
  scene.liquid = {996.7775, 0.8352e-3, 0.157033};
  scene.fluid.tier = tier;
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cell_height = 0.006;
  scene.fluid.inlet_velocity = inlet;
  scene.species = {{"alumina", 0.003087, 3585.9, 300}};
  scene.contact.sliding_friction = 0.1;
  scene.coupling.drag_law = "rong-2013";
  scene.stages[1].duration = 3.0;
  return scene;
}

// What the pressure drop lacks of the buoyant weight over the area stands on the distributor or is the momentum that
// the liquid brings: ρ U²/α on entering, ρ U² on leaving. With the superficial velocity at the inlet there is none.
TEST(MomentumAtTheEnds, IsWhatThePressureDropLacks) {
  for (const FluidTier tier : {FluidTier::one_dimensional, FluidTier::three_dimensional})
    for (const InletVelocity inlet : {InletVelocity::interstitial, InletVelocity::superficial}) {
      const Scene scene = heavy_bed(tier, inlet);
      RunOptions run_options;
      run_options.directory =
          std::filesystem::temp_directory_path() / "slfb_force_balance_test" /
          ("ends" + std::to_string(static_cast<int>(tier)) + std::to_string(static_cast<int>(inlet)));
      std::filesystem::remove_all(run_options.directory);
      const BedSeries bed = run_scene(scene, run_options).result.bed;
      const double weight = -bed.buoyant_weight.back(), area = scene.geometry.cross_section();
      const double drop = mean_of_second_half(bed.pressure_drop) * area / weight,
                   bottom = mean_of_second_half(bed.bottom_force) / weight,
                   flow = mean_of_second_half(bed.flow_force) / weight;
      RecordProperty(std::string(tier == FluidTier::one_dimensional ? "one" : "three") +
                         (inlet == InletVelocity::superficial ? "_superficial" : "_interstitial"),
                     std::to_string(drop) + " " + std::to_string(bottom) + " " + std::to_string(flow));
      EXPECT_NEAR(drop + bottom + flow, 1.0, 3e-3) << "a steady bed gains no momentum";
      const double kinetic = 996.7775 * 0.157033 * 0.157033 * area / weight;  // ρ U² A
      if (inlet == InletVelocity::superficial) {
        EXPECT_NEAR(flow, 0.0, tier == FluidTier::one_dimensional ? 1e-6 : 0.1 * kinetic);
      } else {
        // Between a bottom of voidage 0.9 and a packed one.
        EXPECT_GT(flow, kinetic * (1.0 / 0.9 - 1.0));
        EXPECT_LT(flow, kinetic * (1.0 / 0.36 - 1.0));
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Options, ForceBalance, testing::ValuesIn(options()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace slfb
