#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/fluid/three_dimensional_liquid.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr double diameter = 1e-5, speed = 1e-4;  // so small that the law is that of creeping flow
constexpr int layers = 9;

/// Spheres on a face-centred lattice that fits the cells, all drifting sideways through liquid at rest and kept at
/// their places: along x nothing but drag acts, and the slip decays at the rate β (1/ρ_L α + 1/ρ_S α_S).
TrialResult solve(const Scene& given, const Parameters& parameters, int) {
  const double solids = parameters.at("solids"), voidage = 1.0 - solids;
  const double unit = diameter * std::cbrt(4.0 * std::numbers::pi / 6.0 / solids);
  const double sphere_density = parameters.at("density_ratio") * given.liquid.density;
  const double beta = 150.0 * solids * solids * given.liquid.viscosity / (voidage * diameter * diameter);
  const double rate = beta * (1.0 / (given.liquid.density * voidage) + 1.0 / (sphere_density * solids));
  Scene scene = given;
  scene.geometry.width = {2.0 * unit, 2.0 * unit};
  // Cells ten lattice units high: the inlet, at rest, takes a thousandth of the momentum.
  scene.geometry.height = 10 * layers * unit;
  scene.fluid.tier = FluidTier::three_dimensional;
  scene.fluid.cells_across = 2;
  scene.fluid.cell_height = 10.0 * unit;
  scene.fluid.pressure_tolerance = 1e-12;
  scene.species = {{"sphere", diameter, sphere_density, 1}};
  scene.coupling.drag_law = "ergun-1952";
  scene.contact.stiffness = 1e-9;
  const auto steps = static_cast<int>(parameters.at("steps"));
  // Either a stiffness β Δt/ρ is asked for, or one relaxation time in so many steps.
  const double stiffness = parameters.at("stiffness");
  const double time_step = stiffness > 0.0 ? stiffness * given.liquid.density / beta : 1.0 / (rate * steps);
  scene.fluid.time_step = scene.contact.time_step = time_step;

  dem::Engine engine = make_engine(scene.contact, {}, {0.0, 0.0, 0.0}, 1);
  fluid::ThreeDimensionalLiquid liquid(scene);
  coupling::PhaseCoupling exchange(scene, liquid, find_drag_law(scene.coupling.drag_law));
  for (int k = 0; k < 10 * layers; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        for (const auto& [x, y, z] :
             {std::array{0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}}) {
          const auto s = engine.add_particle({(i - 1 + x) * unit, (j - 1 + y) * unit, (k + z) * unit}, 0.5 * diameter,
                                             sphere_density, 0);
          engine.particles.velocity.x[s] = speed;
        }
  const auto places = engine.particles.position;
  const auto slip = [&] {
    const auto levels = static_cast<std::size_t>(liquid.grid().layers());
    const auto& u = liquid.velocity(0);
    double of_liquid = 0.0, of_spheres = 0.0, n = 0.0;
    for (std::size_t s = 0; s < u.size() / levels; ++s)
      of_liquid += u[s * levels + levels / 2] * static_cast<double>(levels) / static_cast<double>(u.size());
    const double low = static_cast<double>(levels / 2) * liquid.grid().cell_height();
    for (std::size_t i = 0; i < places.z.size(); ++i)
      if (places.z[i] >= low && places.z[i] < low + liquid.grid().cell_height()) {
        of_spheres += engine.particles.velocity.x[i];
        ++n;
      }
    return of_spheres / n - of_liquid;
  };
  const double start = thread_cpu_seconds();
  double passes = 0.0, now = speed;
  for (int k = 0; k < steps && std::abs(now) < 1e3 * speed; ++k) {
    exchange.advance(engine, time_step);
    passes += exchange.passes();
    engine.advance(1);
    engine.particles.position = places;
    now = slip();
  }
  TrialResult result;
  const double exact = std::exp(-rate * time_step * steps);
  result.values["slip"] = {now / speed, std::abs(now / speed - exact), exact};
  result.values["growth"].value = std::abs(now / speed);
  result.counts = {{"passes over the liquid", passes}};
  result.cpu_seconds = thread_cpu_seconds() - start;
  return result;
}

}  // namespace

Problem relaxation_problem() {
  return {
      "relaxation",
      "A homogeneous suspension drifts through liquid at rest: the slip decays exponentially to the common velocity.",
      "relaxation time",
      "numerics/studies/scenes/sphere.toml",
      {{"slip", "slip over that at the start", "-"}, {"growth", "slip after all steps over that at the start", "-"}},
      {{"solids", 0.4}, {"density_ratio", 2.23}, {"stiffness", 0.0}, {"steps", 40.0}},
      solve};
}

}  // namespace slfb::studies
