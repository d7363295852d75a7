#include "experiments/numerics/bench/coupled_bench.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "experiments/numerics/bench/sphere_file.hpp"
#include "experiments/numerics/studies/coupled_bed.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::bench {
namespace {

std::filesystem::path folder() { return source_folder() / "experiments" / "numerics" / "bench"; }

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

std::vector<CoupledCase> coupled_cases() {
  const auto file = folder() / "cases.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  std::vector<CoupledCase> cases;
  for (TomlTable& one : table.tables("case")) {
    cases.push_back({one.text("name"), one.text("description"), one.texts("set")});
    one.reject_others();
  }
  table.reject_others();
  return cases;
}

CoupledCase coupled_case(const std::string& name) {
  std::vector<std::string> known;
  for (CoupledCase& one : coupled_cases()) {
    if (one.name == name) return one;
    known.push_back(one.name);
  }
  throw std::invalid_argument(fmt::format("there is no case \"{}\"; known: {}", name, fmt::join(known, ", ")));
}

Scene column_scene(const Overrides& overrides) { return load_scene(folder() / "column.toml", overrides); }

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
