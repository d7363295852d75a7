#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

/// How long the coupled solver takes per simulated second, and where the time goes.
namespace slfb::bench {

struct CoupledCase {
  std::string name, description;
  std::vector<std::string> overrides;  ///< of the scene with the paper's numerics
};

/// The paper's runs: its mesh size, fluid step and solid step, with the suite's schemes.
const std::vector<CoupledCase>& coupled_cases();
Scene scene_of(const CoupledCase& bench);

struct CoupledTiming {
  int threads = 1;
  std::size_t particles = 0, cells = 0;
  double simulated_seconds = 0.0, wall_seconds = 0.0, cpu_seconds = 0.0;
  /// Parts of the wall time [s].
  double void_fraction = 0.0, exchange = 0.0, momentum = 0.0, pressure = 0.0, particle_motion = 0.0;
  double voidage = 0.0, contacts_per_particle = 0.0, pressure_drop = 0.0;
  double pressure_iterations_per_step = 0.0, continuity_error = 0.0;
  [[nodiscard]] double wall_seconds_per_simulated_second() const { return wall_seconds / simulated_seconds; }
  [[nodiscard]] double cpu_seconds_per_simulated_second() const { return cpu_seconds / simulated_seconds; }
};

/// Fluidises the scene's spheres from a loose packing and then times `seconds` of simulated time. The fluidised state
/// is kept in `cache`.
CoupledTiming time_coupled(const Scene& scene, int threads, double seconds, const std::filesystem::path& cache,
                           const std::function<void(const std::string&)>& say);

}  // namespace slfb::bench
