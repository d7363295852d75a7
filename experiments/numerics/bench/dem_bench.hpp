#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/dem/engine.hpp"

/// The four scenes on which the particle engine is timed, alone and beside other codes.
namespace slfb::bench {

struct DemScene {
  char letter;
  std::string description;
  std::size_t particles;
  double diameter;              ///< [m]
  double time_step;             ///< [s]
  std::int64_t warm_up, steps;  ///< before the clock starts; per repetition
};

/// A: settled in a narrow cylinder; B: the same, smaller spheres; C: an elastic gas; D: settled in a wide box.
const std::vector<DemScene>& dem_scenes();

/// An engine with the scene's spheres, settled or melted. The state is computed once and kept in the folder `cache`;
/// `say` is called with a message before that. Throws std::runtime_error when the file cannot be read or written.
dem::Engine prepare(const DemScene& scene, int threads, const std::filesystem::path& cache,
                    const std::function<void(const std::string&)>& say);

struct DemTiming {
  DemScene scene;
  int threads;
  std::vector<double> rates;                         ///< particle-steps per second, one per repetition
  double contacts_per_particle, pairs_per_particle;  ///< touching; in the neighbour list [-]
  double list_builds_per_step;                       ///< how often the neighbour list is built anew [-]
  [[nodiscard]] double median_rate() const;
  /// Wall time of a contact of two spheres if contacts were all there is [ns].
  [[nodiscard]] double nanoseconds_per_contact() const;
};

/// Times `repetitions` times `steps` steps of the engine, after the scene's warm-up.
DemTiming time_dem(const DemScene& scene, dem::Engine& engine, int repetitions, std::int64_t steps);

/// Writes the state as a data file of LAMMPS or LIGGGHTS (atom_style sphere, SI units). Throws std::system_error when
/// the file cannot be written.
void write_lammps(const DemScene& scene, const dem::Engine& engine, const std::filesystem::path& file);

}  // namespace slfb::bench
