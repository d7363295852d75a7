#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/laws/scene_file.hpp"

/// How long the parts of the solver take on this machine.
namespace slfb::bench {

/// A case of cases.toml.
struct CoupledCase {
  std::string name, description;
  Overrides overrides;  ///< of column.toml
};

/// \throws std::runtime_error with file, line and key
std::vector<CoupledCase> coupled_cases();
/// \throws std::invalid_argument that lists the known ones
CoupledCase coupled_case(const std::string& name);
/// column.toml with overrides on top. \throws SceneError that names the override that is wrong
Scene column_scene(const Overrides& overrides);

/// Where the time of spheres and liquid together goes.
struct CoupledTiming {
  int threads = 1;
  std::size_t particles = 0, cells = 0;
  double simulated_seconds = 0.0, wall_seconds = 0.0, cpu_seconds = 0.0;  ///< [s]
  /// Parts of the wall time [s].
  double void_fraction = 0.0, exchange = 0.0, momentum = 0.0, pressure = 0.0, particle_motion = 0.0;
  double voidage = 0.0, contacts_per_particle = 0.0;  ///< of the bed at the end [-]
  double pressure_iterations_per_step = 0.0;          ///< [-]
  double continuity_error = 0.0;                      ///< of the last step, over the inlet's volume flow [-]
  [[nodiscard]] double wall_seconds_per_simulated_second() const { return wall_seconds / simulated_seconds; }
  [[nodiscard]] double cpu_seconds_per_simulated_second() const { return cpu_seconds / simulated_seconds; }
};

/// Fluidises the scene's spheres from a loose packing and then times `seconds` of simulated time [s].
/// \param cache folder in which the fluidised state is kept, so that it is computed once
/// \param say is called with a message before anything that takes long
/// \throws std::runtime_error when a method breaks down or a file cannot be written
CoupledTiming time_coupled(const Scene& scene, int threads, double seconds, const std::filesystem::path& cache,
                           const std::function<void(const std::string&)>& say);

}  // namespace slfb::bench
