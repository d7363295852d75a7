#include <cmath>
#include <memory>

#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/fluid/liquid.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/one_particle.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr const char* scene_file = "numerics/studies/scenes/sphere.toml";

std::vector<ProblemQuantity> quantities() { return {{"terminal_velocity", "terminal velocity", "m/s"}}; }

/// Root of the law's own balance: drag on a sphere alone equal to its buoyant weight [m/s].
double terminal_velocity(const Scene& scene) {
  const Species& sphere = scene.species.front();
  return fluidisation::superficial_velocity(find_drag_law(scene.coupling.drag_law), {sphere.diameter, sphere.density},
                                            {scene.liquid.density, scene.liquid.viscosity}, 1.0);
}

TrialValue compared(double velocity, double exact) { return {velocity, std::abs(velocity - exact), exact}; }

TrialResult by_root(const Scene& scene, const Parameters&, int) {
  TrialResult result;
  constexpr int repetitions = 2000;  // for a time that can be measured
  const double start = thread_cpu_seconds();
  double velocity = 0.0;
  for (int k = 0; k < repetitions; ++k) velocity = terminal_velocity(scene);
  result.cpu_seconds = (thread_cpu_seconds() - start) / repetitions;
  // The root is the definition: how far it is from itself at the tolerance of the search.
  result.values["terminal_velocity"] = {velocity, 1e-12 * velocity, velocity};
  result.counts["roots"] = 1.0;
  return result;
}

TrialResult by_ode(const Scene& scene, const Parameters& parameters, int) {
  const Species& sphere = scene.species.front();
  OneParticleFall fall;
  fall.diameter = sphere.diameter;
  fall.density = sphere.density;
  fall.liquid_density = fall.surrounding_density = scene.liquid.density;
  fall.viscosity = scene.liquid.viscosity;
  fall.drag_law = scene.coupling.drag_law;
  TrialResult result;
  const double start = thread_cpu_seconds();
  const double seconds = parameters.at("seconds");
  constexpr int repetitions = 20;
  double velocity = 0.0;
  for (int k = 0; k < repetitions; ++k) velocity = -integrate_fall(fall, {0.0, seconds}).back().velocity;
  result.cpu_seconds = (thread_cpu_seconds() - start) / (repetitions * seconds);
  result.values["terminal_velocity"] = compared(velocity, terminal_velocity(scene));
  result.counts["trajectories"] = 1.0;
  return result;
}

TrialResult by_simulation(const Scene& scene, const Parameters& parameters, int) {
  const Species& sphere = scene.species.front();
  const double width = scene.geometry.width[0];
  dem::Engine engine = make_engine(scene.contact, {}, {width, width, 0.0}, 1);
  const auto liquid = fluid::make_liquid(scene);
  coupling::PhaseCoupling exchange(scene, *liquid, find_drag_law(scene.coupling.drag_law));
  engine.add_particle({0.0, 0.0, scene.stages.front().release_height}, 0.5 * sphere.diameter, sphere.density, 0);
  const double seconds = parameters.at("seconds"), step = scene.fluid.time_step;
  const auto steps = std::llround(seconds / step), substeps = std::llround(step / scene.contact.time_step);
  const double start = thread_cpu_seconds();
  double sum = 0.0, n = 0.0;
  for (std::int64_t k = 0; k < steps; ++k) {
    exchange.advance(engine, step);
    engine.advance(substeps);
    // The last fifth: the sphere crosses cells, and its velocity wavers with its place in them.
    if (k < steps * 4 / 5) continue;
    sum -= engine.particles.velocity.z[0];
    ++n;
  }
  TrialResult result;
  result.cpu_seconds = (thread_cpu_seconds() - start) / seconds;
  const TrialValue found = compared(sum / n, terminal_velocity(scene));
  result.values["terminal_velocity"] = found;
  result.values["velocity_error"].value = found.error / found.exact;
  result.counts["particle-steps"] = static_cast<double>(steps * substeps) / seconds;
  if (liquid->two_way())
    result.counts["cell-steps"] = static_cast<double>(liquid->grid().size()) * static_cast<double>(steps) / seconds;
  return result;
}

}  // namespace

Problem fall_by_root_problem() {
  return {"fall-by-root", "Terminal velocity of a sphere alone as the root of the drag law.",
          "answer",       scene_file,
          quantities(),   {},
          by_root};
}

Problem fall_by_ode_problem() {
  return {"fall-by-ode",
          "The same from its equation of motion, by CVODE.",
          "simulated second",
          scene_file,
          quantities(),
          {{"seconds", 1.0}},
          by_ode};
}

Problem fall_problem() {
  return {"fall",
          "The same in the simulation, in the liquid's tier of the scene; exact: the root of the law.",
          "simulated second",
          scene_file,
          {quantities().front(), {"velocity_error", "error of the terminal velocity", "-"}},
          {{"seconds", 1.0}},
          by_simulation};
}

}  // namespace slfb::studies
