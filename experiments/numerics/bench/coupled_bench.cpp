#include "experiments/numerics/bench/coupled_bench.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "experiments/numerics/bench/sphere_file.hpp"
#include "experiments/numerics/studies/coupled_bed.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/folders.hpp"

namespace slfb::bench {
namespace {

/// Time in which a bed that starts from a loose packing forgets it [s].
constexpr double fluidisation = 1.5;

/// The same with long steps: only the start of the measurement is made with it.
Scene coarse(Scene scene) {
  scene.fluid.time_step = 1e-3;
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.contact.allow_large_time_step = true;
  return scene;
}

double process_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Spheres of a bed that has forgotten its start.
dem::Particles fluidised(const Scene& scene, int threads, const std::filesystem::path& cache,
                         const std::function<void(const std::string&)>& say) {
  const Scene start = coarse(scene);
  const auto file = cache / fmt::format("fluidised_{}.h5", scene_hash(start));
  if (std::filesystem::exists(file)) return load_spheres(file);
  say(fmt::format("fluidising {} spheres for {} s with long steps, once", start.species.front().count, fluidisation));
  const dem::Particles spheres = studies::fluidised(start, fluidisation, threads);
  save_spheres(file, spheres);
  return spheres;
}

}  // namespace

const std::vector<CoupledCase>& coupled_cases() {
  // The residual of the pressure equation is the source's.
  const std::vector<std::string> common{"fluid.pressure_velocity=projection", "fluid.pressure_tolerance=1e-5",
                                        "coupling.void_fraction=exact-overlap"};
  const auto with = [&](std::vector<std::string> own) {
    own.insert(own.begin(), common.begin(), common.end());
    return own;
  };
  static const std::vector<CoupledCase> cases{
      {"paper-3mm", "16668 spheres of 3 mm in water at 0.06 m/s; liquid step 1e-4 s, solid step 3.3e-5 s",
       with({"species[0].diameter=3 mm", "liquid.superficial_velocity=0.06 m/s",
             "contact.time_step=3.3333333333333e-5 s"})},
      {"paper-5mm", "3600 spheres of 5 mm in water at 0.10 m/s; liquid step 1e-4 s, solid step 5e-5 s",
       with({"liquid.superficial_velocity=0.10 m/s"})}};
  return cases;
}

Scene scene_of(const CoupledCase& bench) {
  return load_scene(source_folder() / "experiments/peng_2014/scenes/6in5W_paper-literal.toml", bench.overrides);
}

CoupledTiming time_coupled(const Scene& scene, int threads, double seconds, const std::filesystem::path& cache,
                           const std::function<void(const std::string&)>& say) {
  using Clock = std::chrono::steady_clock;
  studies::CoupledBed bed(scene, fluidised(scene, threads, cache, say), threads);
  // The liquid starts anew and needs some time to match the spheres.
  bed.advance(0.02);
  const double void_fraction_before = bed.exchange.void_fraction_seconds();
  const auto liquid_before = bed.liquid.cost();
  const double particles_before = bed.particle_seconds;
  const double cpu_before = process_cpu_seconds();
  const auto start = Clock::now();
  bed.advance(seconds);
  CoupledTiming timing;
  timing.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  timing.cpu_seconds = process_cpu_seconds() - cpu_before;
  timing.threads = threads;
  timing.simulated_seconds = seconds;
  timing.particles = bed.engine.particles.size();
  timing.cells = bed.liquid.grid().size();
  timing.void_fraction = bed.exchange.void_fraction_seconds() - void_fraction_before;
  timing.momentum = bed.liquid.cost().momentum_seconds - liquid_before.momentum_seconds;
  timing.pressure = bed.liquid.cost().pressure_seconds - liquid_before.pressure_seconds;
  timing.particle_motion = bed.particle_seconds - particles_before;
  timing.exchange =
      timing.wall_seconds - timing.void_fraction - timing.momentum - timing.pressure - timing.particle_motion;
  const double steps = seconds / scene.fluid.time_step;
  timing.pressure_iterations_per_step =
      static_cast<double>(bed.liquid.cost().pressure_iterations - liquid_before.pressure_iterations) / steps;
  timing.continuity_error = bed.liquid.continuity_error();
  timing.pressure_drop = bed.liquid.inlet_pressure();
  const auto n = static_cast<double>(timing.particles);
  double moment = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < timing.particles; ++i) {
    timing.contacts_per_particle += bed.engine.contacts(i) / n;
    moment += bed.engine.particles.volume(i) * bed.engine.particles.position.z[i];
    volume += bed.engine.particles.volume(i);
  }
  timing.voidage = 1.0 - volume / (bed.liquid.grid().section_area() * 2.0 * moment / volume);
  return timing;
}

}  // namespace slfb::bench
