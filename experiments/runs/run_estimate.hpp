#pragma once

#include <cstdint>
#include <string>

#include "solver/scene/scene.hpp"

namespace slfb {

/// What a scene will cost, known before it runs.
struct RunEstimate {
  std::int64_t spheres = 0;         ///< at the start
  std::int64_t liquid_cells = 0;    ///< 0 for a quiescent liquid
  double time_step_bound = 0.0;     ///< 1/ω_0 of the stiffest pair [s]
  double steps_per_contact = 0.0;   ///< DEM steps in the half period π/ω_0 of the stiffest pair [-]
  double simulated_seconds = 0.0;   ///< with dropped spheres taken to fall for `typical_fall` [s]
  double longest_seconds = 0.0;     ///< with each dropped sphere waited for as long as the scene allows [s]
  std::int64_t particle_steps = 0;  ///< spheres times DEM steps in simulated_seconds
  std::int64_t cell_steps = 0;      ///< liquid cells times liquid steps in simulated_seconds; the bed settles without
  double memory = 0.0;              ///< that the run takes at the most, checkpoints included [bytes]
  double core_seconds = 0.0;        ///< at the rates below [s]
};

/// How long a dropped sphere is taken to fall when nothing is known about it [s].
inline constexpr double typical_fall = 3.0;

/// Rates of one core, for estimates only: contacts, and the liquid with its coupling to the spheres [1/s]. With them
/// the estimate lies within a quarter of the CPU times of the published runs of 6in5W and 6in3W
/// (reports/published/peng_2014/runs).
inline constexpr double particle_steps_per_core_second = 11.6e6;
inline constexpr double cell_steps_per_core_second = 3.7e6;

/// Memory for each sphere and each cell, for estimates only [bytes]. `slfb run` took 1700 for a sphere and 1400 for a
/// cell (maximum resident set with a checkpoint after each step, 100 to 50 000 spheres of 5 mm and 3000 to 280 000
/// cells) above 30 MB; here it is half as much more, for denser beds and larger clouds of shares.
inline constexpr double bytes_per_sphere = 2500.0, bytes_per_cell = 2000.0, bytes_at_least = 60e6;

RunEstimate estimate_run(const Scene& scene);

/// What is wrong with running a scene on this machine: "needs about 90 GB of memory, and this machine has 8 GB"; empty
/// if nothing is.
std::string memory_problem(const RunEstimate& estimate);

/// "4.5 s", "45 s", "3 min 05 s", "2 h 10 min".
std::string format_duration(double seconds);

}  // namespace slfb
