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
  std::int64_t dry_steps = 0;       ///< of the particle steps, those of a bed that settles without liquid
  std::int64_t packed_steps = 0;  ///< of the particle steps, those of a bed that settles in liquid or is not yet loose
  std::int64_t exchange_steps = 0;     ///< spheres times the steps in which they feel the liquid
  std::int64_t piece_steps = 0;        ///< pieces of particle meshing that are put into cells
  std::int64_t simple_steps = 0;       ///< of the cell steps, those with SIMPLE
  std::int64_t disturbance_steps = 0;  ///< of the exchange steps, those corrected for the spheres' own disturbance
  std::int64_t added_mass_steps = 0;   ///< of the exchange steps, those with added mass
  double memory = 0.0;                 ///< that the run takes at the most, checkpoints included [bytes]
  double core_seconds = 0.0;           ///< counts times the costs below [s]
};

/// How long a dropped sphere is taken to fall when nothing is known about it [s].
inline constexpr double typical_fall = 3.0;

/// CPU time for each count, for estimates only [s]: a least-squares fit of relative errors, tempered against outliers,
/// to 412 published runs (one thread of an AMD EPYC, 2026-11-30; columns and periodic boxes, one and three dimensions,
/// 324 to 3600 spheres of 0.5 to 6.35 mm) and to the four of the profile paper-steps (liquid steps of 0.1 ms; an Intel
/// Xeon), which count five times, of 1, 5 and 15 tried: they alone tell the cost of an exchange step from that of its
/// ten or more particle steps. The machines were busy: CPU times scatter by some 15 %. 92 % of the runs of the fit lie
/// within 30 %. Outside it: runs of other days took up to 2.3 times the estimate. `loose` is for the particle steps of
/// a fluidised bed.
///
/// The second line has what some choices cost beside: differences of runs of a small box with and without each (200
/// spheres of 5 mm, a busy Intel Xeon, 2026-12-01) over their counts; `slfb bench estimate` shows how far they are off
/// on another machine. SIMPLE took 155 ns a cell at a liquid step of 0.1 ms and 405 at 1 ms.
struct CostPerCount {
  double dry = 119.3e-9, packed = 51.2e-9, loose = 14.5e-9, cell = 220.4e-9, exchange = 353.0e-9;
  double piece = 0.28e-9, simple = 250e-9, disturbance = 240e-9, added_mass = 125e-9;
};

/// A bed counts as packed up to this multiple of the minimum fluidisation velocity of Wen & Yu (1966): next to it most
/// contacts last. Chosen with the costs, on the same runs, from 1 to 1.45; 1.2 to 1.45 serve alike.
inline constexpr double packed_up_to = 1.3;

/// Memory for each sphere and each cell, for estimates only [bytes]. `slfb run` took 1700 for a sphere and 1400 for a
/// cell (maximum resident set with a checkpoint after each step, 100 to 50 000 spheres of 5 mm and 3000 to 280 000
/// cells) above 30 MB; here it is half as much more, for denser beds and larger clouds of shares.
inline constexpr double bytes_per_sphere = 2500.0, bytes_per_cell = 2000.0, bytes_at_least = 60e6;

/// \param fall how long a dropped sphere falls, if known; at most the stage's duration is counted [s]
RunEstimate estimate_run(const Scene& scene, double fall = typical_fall);

/// What is wrong with running a scene on this machine: "needs about 90 GB of memory, and this machine has 8 GB"; empty
/// if nothing is.
std::string memory_problem(const RunEstimate& estimate);

/// "4.5 s", "45 s", "3 min 05 s", "2 h 10 min".
std::string format_duration(double seconds);

}  // namespace slfb
