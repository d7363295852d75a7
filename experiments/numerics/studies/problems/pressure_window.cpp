#include <algorithm>
#include <cmath>

#include "correlations/materials.hpp"
#include "experiments/numerics/studies/coupled_bed.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

/// The bed of the study of pressure noise in small.
Scene start_scene(const Scene& scene) {
  Scene small = glass_bed();
  small.geometry.diameter = 0.025;
  small.geometry.height = 0.14;
  small.fluid.cells_across = 4;
  small.species.front().count = 150;
  small.seed = scene.seed;
  return small;
}

TrialResult solve(const Scene& given, const Parameters& parameters, int) {
  Scene scene = start_scene(given);
  // Half a second of fluidisation with the schemes of the suite; the spheres go on without rotation.
  dem::Particles spheres = fluidised(scene, 0.5);
  spheres.angular_velocity.set_zero();
  const auto geometry = scene.geometry;
  const auto cells = scene.fluid.cells_across;
  const auto height = scene.fluid.cell_height;
  scene.fluid = given.fluid;
  scene.fluid.wall = LateralBoundary::no_slip;
  scene.coupling = given.coupling;
  // A divisor of the liquid's step, any of which a map may ask for.
  constexpr double longest_solid_step = 1e-4;
  scene.contact.time_step = given.fluid.time_step / std::ceil(given.fluid.time_step / longest_solid_step - 1e-9);
  // Cells in diameters of the spheres, if asked for.
  const double cell = parameters.at("cell");
  scene.fluid.cells_across =
      cell > 0.0 ? std::max(1, static_cast<int>(std::lround(geometry.diameter / (cell * 0.005)))) : cells;
  scene.fluid.cell_height = cell > 0.0 ? cell * 0.005 : height;

  CoupledBed bed(scene, spheres);
  const dem::Engine& engine = bed.engine;
  const fluid::Liquid& liquid = bed.liquid;
  bed.advance(parameters.at("transient"));
  const double seconds = parameters.at("seconds");
  const auto iterations = liquid.cost().pressure_iterations;
  double sum = 0.0, squares = 0.0, n = 0.0, drift = 0.0;
  const double start = thread_cpu_seconds();
  bed.advance(seconds, [&] {
    sum += liquid.inlet_pressure();
    squares += liquid.inlet_pressure() * liquid.inlet_pressure();
    drift = std::max(drift, liquid.continuity_error());
    ++n;
  });
  TrialResult result;
  result.cpu_seconds = (thread_cpu_seconds() - start) / seconds;
  double weight = 0.0, mean_velocity = 0.0;
  for (std::size_t i = 0; i < engine.particles.size(); ++i) {
    weight +=
        gravitational_acceleration * (engine.particles.mass[i] - scene.liquid.density * engine.particles.volume(i));
    mean_velocity += engine.particles.velocity.z[i] / static_cast<double>(engine.particles.size());
  }
  const double mean = sum / n;
  result.values["pressure_drop"].value = mean;
  result.values["sphere_velocity"].value = mean_velocity;
  result.values["mass_drift"].value = drift;
  result.values["pressure_noise"].value =
      std::sqrt(std::max(0.0, squares / n - mean * mean)) * liquid.grid().section_area() / weight;
  result.counts["pressure iterations"] = static_cast<double>(liquid.cost().pressure_iterations - iterations) / seconds;
  result.counts["cell-steps"] = static_cast<double>(liquid.grid().size()) * n / seconds;
  return result;
}

}  // namespace

Problem pressure_window_problem() {
  return {"pressure-window",
          "150 fluidised spheres in a 25 mm column, followed for a short time from one and the same state.",
          "simulated second",
          "numerics/studies/scenes/box.toml",
          {{"pressure_drop", "mean pressure drop", "Pa"},
           {"sphere_velocity", "mean velocity of the spheres at the end", "m/s"},
           {"mass_drift", "largest violation of continuity over the inflow", "-"},
           {"pressure_noise", "r.m.s. of the pressure drop over the bed's weight", "-"}},
          {{"seconds", 0.05}, {"transient", 0.02}, {"cell", 0.0}},
          solve};
}

}  // namespace slfb::studies
