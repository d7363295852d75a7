#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/materials.hpp"
#include "experiments/numerics/stability/map.hpp"
#include "solver/coupling/late_reaction.hpp"
#include "solver/dem/particles.hpp"
#include "solver/laws/scene_drag_law.hpp"

namespace slfb::stability {
namespace {

using Formula = std::function<double(const Scene&, const studies::Parameters&)>;

double superficial_velocity(const Scene& scene, double voidage) {
  const Species& sphere = scene.species.front();
  return fluidisation::superficial_velocity(scene_drag_law(scene), {sphere.diameter, sphere.density},
                                            {scene.liquid.density, scene.liquid.viscosity}, voidage);
}

const std::vector<std::pair<std::string, Formula>>& formulas() {
  static const std::vector<std::pair<std::string, Formula>> list{
      // Symplectic Euler and Verlet on a harmonic oscillator (Hairer, Lubich & Wanner 2006, I.1.4).
      {"two-over-omega",
       [](const Scene& scene, const studies::Parameters&) {
         const Species& sphere = scene.species.front();
         const double mass = sphere.density * dem::Particles::volume_of(0.5 * sphere.diameter);
         return 2.0 * std::sqrt(mass / scene.contact.stiffness);
       }},
      // What the scene checks demand.
      {"one-over-omega-pair",
       [](const Scene& scene, const studies::Parameters&) { return contact_time_step_bound(scene); }},
      // Explicit Euler on the slip, which decays at β (1/ρ_L α + 1/ρ_S α_S).
      {"explicit-exchange",
       [](const Scene&, const studies::Parameters& parameters) {
         const double solids = parameters.at("solids");
         return 2.0 / (1.0 / (1.0 - solids) + 1.0 / (parameters.at("density_ratio") * solids));
       }},
      // The same with a bed's own β: the slope of drag over slip in the homogeneous bed that the velocity carries, by
      // its
      // response to slightly heavier spheres. NaN where there is no such bed.
      {"explicit-exchange-of-bed",
       [](const Scene& scene, const studies::Parameters&) {
         const Species& sphere = scene.species.front();
         const auto law = scene_drag_law(scene);
         const LiquidProperties liquid{scene.liquid.density, scene.liquid.viscosity};
         const auto [voidage, regime] = fluidisation::bed_voidage(law, {sphere.diameter, sphere.density}, liquid,
                                                                  scene.liquid.superficial_velocity, 0.4);
         if (regime != fluidisation::BedRegime::expanded) return std::nan("");
         const double solids = 1.0 - voidage, heavier = 1e-3 * sphere.density;
         const double faster =
             fluidisation::superficial_velocity(law, {sphere.diameter, sphere.density + heavier}, liquid, voidage);
         // Slip is U/α, drag on a volume of the bed α α_S (ρ_S - ρ_L) g.
         const double slope = voidage * voidage * solids * heavier * gravitational_acceleration /
                              (faster - scene.liquid.superficial_velocity);
         return 2.0 / (slope * (1.0 / (voidage * liquid.density) + 1.0 / (solids * sphere.density)));
       }},
      // The liquid answers the spheres one step late.
      {"late-reaction",
       [](const Scene& scene, const studies::Parameters& parameters) {
         Scene of_problem = scene;
         of_problem.fluid.tier = FluidTier::three_dimensional;
         of_problem.coupling.void_fraction_interval = parameters.at("interval_steps") * scene.fluid.time_step;
         return coupling::least_density_ratio(of_problem, 1.0 - parameters.at("solids"));
       }},
      {"minimum-fluidisation",
       [](const Scene& scene, const studies::Parameters&) { return superficial_velocity(scene, 0.4); }},
      {"wash-out", [](const Scene& scene, const studies::Parameters&) { return superficial_velocity(scene, 1.0); }}};
  return list;
}

}  // namespace

std::vector<std::string> theory_formulas() {
  std::vector<std::string> names;
  for (const auto& [name, formula] : formulas()) names.push_back(name);
  return names;
}

double theory_value(const std::string& name, const Scene& scene, const studies::Parameters& parameters) {
  for (const auto& [known, formula] : formulas())
    if (known == name) return formula(scene, parameters);
  throw std::invalid_argument(
      fmt::format("there is no formula \"{}\"; known: {}", name, fmt::join(theory_formulas(), ", ")));
}

}  // namespace slfb::stability
