#include "experiments/runs/run_estimate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/fluid/column_grid.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb {
namespace {

std::int64_t liquid_cells(const Scene& scene) {
  if (scene.fluid.tier == FluidTier::quiescent) return 0;
  return static_cast<std::int64_t>(fluid::ColumnGrid(scene).size());
}

}  // namespace

RunEstimate estimate_run(const Scene& scene) {
  RunEstimate estimate;
  for (const Species& species : scene.species) estimate.spheres += species.count;
  estimate.liquid_cells = liquid_cells(scene);
  // In a look without running, a law from a file tells nothing.
  estimate.time_step_bound = is_user_law(scene.contact.law) && NoForeignCode::holds()
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : contact_time_step_bound(scene);
  estimate.steps_per_contact = std::numbers::pi * estimate.time_step_bound / scene.contact.time_step;

  bool dropping = false;
  double settling_seconds = 0.0;
  for (const Stage& stage : scene.stages) {
    if (stage.kind == StageKind::drop) {
      dropping = true;
      estimate.simulated_seconds += stage.repetitions * (std::min(stage.duration, typical_fall) + stage.relaxation);
      estimate.longest_seconds += stage.repetitions * (stage.duration + stage.relaxation);
    } else {
      estimate.simulated_seconds += stage.duration;
      estimate.longest_seconds += stage.duration;
      if (stage.kind == StageKind::settle) settling_seconds += stage.duration;
    }
  }
  const double spheres = static_cast<double>(estimate.spheres + (dropping ? 1 : 0));
  estimate.particle_steps = std::llround(spheres * estimate.simulated_seconds / scene.contact.time_step);
  estimate.cell_steps = std::llround(static_cast<double>(estimate.liquid_cells) *
                                     (estimate.simulated_seconds - settling_seconds) / scene.fluid.time_step);
  estimate.core_seconds = static_cast<double>(estimate.particle_steps) / particle_steps_per_core_second +
                          static_cast<double>(estimate.cell_steps) / cell_steps_per_core_second;
  estimate.memory =
      bytes_at_least + bytes_per_sphere * spheres + bytes_per_cell * static_cast<double>(estimate.liquid_cells);
  return estimate;
}

std::string memory_problem(const RunEstimate& estimate) {
  const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (estimate.memory <= there) return "";
  return fmt::format(
      "needs about {:.3g} GB of memory for {} spheres and {} liquid cells, and this machine has {:.3g} GB; fewer "
      "spheres, or larger cells",
      1e-9 * estimate.memory, estimate.spheres, estimate.liquid_cells, 1e-9 * there);
}

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  if (seconds < 10.0) return fmt::format("{:.1f} s", std::max(seconds, 0.0));
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace slfb
