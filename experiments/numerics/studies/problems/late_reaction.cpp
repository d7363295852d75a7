#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

constexpr double sphere_diameter = 5e-3, first_speed = 1e-3, liquid_step = 1e-5;
constexpr int cell_layers = 9;

/// Spheres in columns that fit the cells, with hardly any contact stiffness, rise together in a liquid that has hardly
/// any viscosity: what one step does to their velocity comes back through the pressure in the next. They move less than
/// a thousandth of a diameter.
TrialResult shake(const Scene& given, const Parameters& parameters, int) {
  const double unit = sphere_diameter * std::cbrt(4.0 * std::numbers::pi / 6.0 / parameters.at("solids"));
  const double density = parameters.at("density_ratio") * given.liquid.density;
  Scene scene = given;
  scene.geometry.width = {2.0 * unit, 2.0 * unit};
  scene.geometry.height = 10 * cell_layers * unit;
  scene.fluid.cells_across = 2;
  scene.fluid.cell_height = 10.0 * unit;
  scene.fluid.pressure_tolerance = 1e-12;
  scene.fluid.time_step = scene.contact.time_step = liquid_step;
  scene.liquid.viscosity = 1e-7;
  scene.species = {{"sphere", sphere_diameter, density, 1}};
  scene.coupling.drag_law = "ergun-1952";
  scene.coupling.void_fraction_interval = parameters.at("interval_steps") * liquid_step;
  scene.contact.stiffness = 1e-3;

  dem::Engine engine = make_engine(scene.contact, {}, {0.0, 0.0, 0.0}, 1);
  fluid::ThreeDimensionalLiquid liquid(scene);
  coupling::PhaseCoupling exchange(scene, liquid, find_drag_law(scene.coupling.drag_law));
  std::vector<std::size_t> middle;
  // A layer of cells below the bed and one above it are clear. Each column of spheres is shifted upwards by another
  // part of the lattice, so that every section through the bed has the same part of solids.
  constexpr std::array sites{std::array{0.25, 0.25}, std::array{0.75, 0.75}, std::array{0.75, 0.25},
                             std::array{0.25, 0.75}};
  for (int k = 10; k < 10 * (cell_layers - 1); ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        for (std::size_t n = 0; n < sites.size(); ++n) {
          const double shift = (4.0 * static_cast<double>(n) + 2 * j + i + 0.5) / 16.0;
          const auto s =
              engine.add_particle({(i - 1 + sites[n][0]) * unit, (j - 1 + sites[n][1]) * unit, (k + shift) * unit},
                                  0.5 * sphere_diameter, density, 0);
          engine.particles.velocity.z[s] = first_speed;
          if (k / 10 == cell_layers / 2) middle.push_back(s);
        }
  const auto rise = [&] {
    double sum = 0.0;
    for (const std::size_t s : middle) sum += engine.particles.velocity.z[s];
    return sum / static_cast<double>(middle.size());
  };
  const double start = thread_cpu_seconds();
  // What changes from step to step: the second difference of the velocity, at first and at the end.
  const int first = 8, steps = static_cast<int>(parameters.at("steps"));
  double before = first_speed, now = first_speed, at_first = 0.0, at_end = 0.0;
  bool bounded = true;
  for (int k = 0; k < steps && bounded; ++k) {
    exchange.advance(engine, liquid_step);
    engine.advance(1);
    const double next = rise(), change = std::abs(next - 2.0 * now + before);
    before = now;
    now = next;
    bounded = std::abs(now) < 1e3 * first_speed;  // false for what is no number
    // The largest of some steps: within an interval of void fractions nothing changes.
    if (k < first) at_first = std::max(at_first, k < 2 ? 0.0 : change);
    if (k % first == 0) at_end = 0.0;
    at_end = std::max(at_end, change);
  }
  TrialResult result;
  result.values["growth"].value = bounded ? at_end / at_first : std::numeric_limits<double>::infinity();
  result.counts = {{"steps", static_cast<double>(steps)}};
  result.cpu_seconds = thread_cpu_seconds() - start;
  return result;
}

}  // namespace

Problem late_reaction_problem() {
  return {"late-reaction",
          "A uniform bed without contacts and drag: the liquid answers the spheres one step late.",
          "run",
          "numerics/studies/scenes/sphere.toml",
          {{"growth", "change of velocity from step to step, at the end over the start", "-"}},
          {{"solids", 0.4}, {"density_ratio", 2.23}, {"interval_steps", 1.0}, {"steps", 64.0}},
          shake};
}

}  // namespace slfb::studies
