#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "correlations/classification/force_balance.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/materials.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/dem/particles.hpp"
#include "solver/fluid/column_grid.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/one_particle.hpp"
#include "solver/run/simulation.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr const char* slice = "numerics/studies/scenes/slice.toml";

/// By the names of measure_runs.
const std::vector<std::pair<ProblemQuantity, std::string>>& measured() {
  static const std::vector<std::pair<ProblemQuantity, std::string>> list{
      {{"voidage", "voidage", "-"}, "voidage_centre_of_mass"},
      {{"pressure_drop", "pressure drop", "Pa"}, "pressure_drop"},
      {{"fluctuating_energy", "q_p² of the spheres", "m²/s²"}, "fluctuating_energy"},
      {{"contacts", "contacts per sphere", "-"}, "contacts_per_particle"},
      {{"classification_velocity", "classification velocity", "m/s"}, "classification_velocity"},
      {{"collision_frequency", "collision frequency", "1/s"}, "collision_frequency"},
      {{"force_ratio", "mean contact force over weight", "-"}, "collision_force_ratio"},
      {{"peak_force", "largest contact force", "-"}, "peak_force_ratio"}};
  return list;
}

std::vector<ProblemQuantity> bed_quantities() {
  std::vector<ProblemQuantity> list;
  for (const auto& [quantity, key] : measured()) list.push_back(quantity);
  list.push_back({"pressure_noise", "r.m.s. of the pressure drop over its mean", "-"});
  return list;
}

/// A folder that goes away; checkpoints of long trials lie there meanwhile.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "slfb-trial-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

TrialResult simulate(const Scene& scene, const Parameters&, int) {
  const Scratch scratch;
  RunOptions options;
  options.directory = scratch.path;
  const RunOutcome outcome = run_scene(scene, options);
  const RunResult& run = outcome.result;
  if (run.particles_removed > 0) throw std::runtime_error(fmt::format("{} spheres were lost", run.particles_removed));
  const RunSpec spec{"trial", scene.liquid.superficial_velocity, "", "", {}};
  const Measurements found = measure_runs({{spec, scene, run}});
  TrialResult result;
  for (const auto& [quantity, key] : measured())
    if (const auto entry = found.find(measure_key(key, spec.system, spec.superficial_velocity)); entry != found.end())
      result.values[quantity.name].value = entry->second.value;
  double sum = 0.0, squares = 0.0, n = 0.0;
  for (std::size_t i = run.bed.time.size() / 4; i < run.bed.time.size(); ++i) {
    if (run.bed.foreign_present[i] > 0.5) break;
    sum += run.bed.pressure_drop[i];
    squares += run.bed.pressure_drop[i] * run.bed.pressure_drop[i];
    ++n;
  }
  if (n > 1.0)
    result.values["pressure_noise"].value = std::sqrt(std::max(0.0, squares / n - sum * sum / n / n)) * n / sum;
  result.cpu_seconds = run.cpu_seconds / run.simulated_seconds;
  result.counts["particle-steps"] = static_cast<double>(run.particle_steps) / run.simulated_seconds;
  if (scene.fluid.tier != FluidTier::quiescent)
    result.counts["cell-steps"] = static_cast<double>(fluid::ColumnGrid(scene).size()) / scene.fluid.time_step;
  return result;
}

/// Buoyant weight of all spheres that are there from the start [N].
double buoyant_weight(const Scene& scene) {
  double weight = 0.0;
  for (const Species& species : scene.species)
    weight += dem::Particles::volume_of(0.5 * species.diameter) * static_cast<double>(species.count) *
              (species.density - scene.liquid.density) * gravitational_acceleration;
  return weight;
}

/// As simulate, with any step of the liquid: that of the spheres is its longest divisor that the problem allows.
TrialResult carry_weight(const Scene& given, const Parameters& parameters, int replicate) {
  Scene scene = given;
  scene.contact.time_step =
      scene.fluid.time_step / std::ceil(scene.fluid.time_step / parameters.at("longest_solid_step") - 1e-9);
  TrialResult result = simulate(scene, parameters, replicate);
  const double needed = buoyant_weight(scene) / (scene.geometry.width[0] * scene.geometry.width[1]);
  result.values["weight_error"].value = std::abs(result.values.at("pressure_drop").value / needed - 1.0);
  return result;
}

/// The homogeneous bed of the scene and the dropped sphere in it.
ForeignSphereInBed homogeneous(const Scene& scene, const drag::DragLawKernels& law) {
  const Species &bed = scene.species.at(0), &dropped = scene.species.at(1);
  const Sphere sphere{bed.diameter, bed.density};
  const LiquidProperties liquid{scene.liquid.density, scene.liquid.viscosity};
  constexpr double packed_voidage = 0.4;
  const auto [voidage, regime] =
      fluidisation::bed_voidage(law, sphere, liquid, scene.liquid.superficial_velocity, packed_voidage);
  if (regime != fluidisation::BedRegime::expanded)
    throw std::runtime_error("the drag law has no homogeneous bed at this velocity");
  return {sphere, {dropped.diameter, dropped.density}, liquid, voidage, scene.liquid.superficial_velocity};
}

TrialResult by_root(const Scene& scene, const Parameters&, int) {
  const auto law = find_drag_law(scene.coupling.drag_law);
  constexpr int repetitions = 500;  // for a time that can be measured
  TrialResult result;
  const double start = thread_cpu_seconds();
  for (int k = 0; k < repetitions; ++k) {
    const ForeignSphereInBed state = homogeneous(scene, law);
    result.values["voidage"].value = state.voidage;
    result.values["classification_velocity"].value = classification::force_balance_velocity(law, state);
  }
  result.cpu_seconds = (thread_cpu_seconds() - start) / repetitions;
  result.values["pressure_drop"].value = buoyant_weight(scene) / (scene.geometry.width[0] * scene.geometry.width[1]);
  result.counts["roots"] = 2.0;
  return result;
}

TrialResult by_ode(const Scene& scene, const Parameters&, int) {
  const auto law = find_drag_law(scene.coupling.drag_law);
  const double start = thread_cpu_seconds();
  const ForeignSphereInBed state = homogeneous(scene, law);
  OneParticleFall fall;
  fall.diameter = state.foreign.diameter;
  fall.density = state.foreign.density;
  fall.liquid_density = state.liquid.density;
  fall.viscosity = state.liquid.viscosity;
  fall.liquid_velocity = state.interstitial_velocity();
  fall.voidage = state.voidage;
  fall.surrounding_density = state.mixture_density();
  fall.drag_law = scene.coupling.drag_law;
  constexpr double seconds = 1.0;
  const double velocity = -integrate_fall(fall, {0.0, seconds}).back().velocity;
  TrialResult result;
  result.cpu_seconds = (thread_cpu_seconds() - start) / seconds;
  result.values["voidage"].value = state.voidage;
  result.values["classification_velocity"].value = velocity;
  result.counts["trajectories"] = 1.0;
  return result;
}

}  // namespace

Problem bed_box_problem() {
  return {"bed-box",
          "200 fluidised spheres of 5 mm in a periodic box.",
          "simulated second",
          "numerics/studies/scenes/box.toml",
          bed_quantities(),
          {},
          simulate};
}

Problem bed_weight_problem() {
  auto quantities = bed_quantities();
  quantities.push_back({"weight_error", "pressure drop over the bed's weight, less one", "-"});
  return {"bed-weight",
          "Fluidised spheres in a periodic box with any liquid step: does the pressure drop carry their weight?",
          "simulated second",
          "numerics/studies/scenes/box.toml",
          std::move(quantities),
          {{"longest_solid_step", 1e-4}},
          carry_weight};
}

Problem bed_slice_problem() {
  return {"bed-slice",
          "A slice of a bed, 733 spheres of 5 mm, and 6 mm steel spheres that are dropped through it.",
          "simulated second",
          slice,
          bed_quantities(),
          {},
          simulate};
}

Problem bed_by_root_problem() {
  return {"bed-by-root",    "Homogeneous bed of the slice and force balance on the dropped sphere, without collisions.",
          "answer",         slice,
          bed_quantities(), {},
          by_root};
}

Problem bed_by_ode_problem() {
  return {"bed-by-ode",
          "Fall of the dropped sphere through a homogeneous bed, by CVODE.",
          "simulated second",
          slice,
          bed_quantities(),
          {},
          by_ode};
}

}  // namespace slfb::studies
