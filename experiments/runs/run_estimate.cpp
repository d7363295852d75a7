#include "experiments/runs/run_estimate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "correlations/fluidisation/minimum_fluidisation/wen_yu_1966.hpp"
#include "solver/fluid/column_grid.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb {
namespace {

std::int64_t liquid_cells(const Scene& scene) {
  if (scene.fluid.tier == FluidTier::quiescent) return 0;
  return static_cast<std::int64_t>(fluid::ColumnGrid(scene).size());
}

/// Up to which superficial velocity the bed counts as packed [m/s]; 0 where the spheres are not heavier than the
/// liquid.
double highest_packed_velocity(const Scene& scene) {
  const auto species = std::ranges::find_if(scene.species, [](const Species& one) { return one.count > 0; });
  if (species == scene.species.end() || species->density <= scene.liquid.density) return 0.0;
  const fluidisation::PackedBed bed{{species->diameter, species->density},
                                    {scene.liquid.density, scene.liquid.viscosity},
                                    0.4};  // the law does not use the voidage
  return packed_up_to * fluidisation::minimum_fluidisation::WenYu1966{}(bed);
}

}  // namespace

RunEstimate estimate_run(const Scene& scene, double fall) {
  RunEstimate estimate;
  for (const Species& species : scene.species) estimate.spheres += species.count;
  estimate.liquid_cells = liquid_cells(scene);
  // In a look without running, a law from a file tells nothing.
  estimate.time_step_bound = is_user_law(scene.contact.law) && NoForeignCode::holds()
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : contact_time_step_bound(scene);
  estimate.steps_per_contact = std::numbers::pi * estimate.time_step_bound / scene.contact.time_step;

  const double packed_velocity = highest_packed_velocity(scene);
  const bool at_rest_below = scene.liquid.superficial_velocity <= packed_velocity;
  bool dropping = false;
  double settling_seconds = 0.0, dry_seconds = 0.0, packed_seconds = 0.0;
  for (const Stage& stage : scene.stages) {
    double seconds = stage.duration;
    bool packed = false;
    if (stage.kind == StageKind::drop) {
      dropping = true;
      seconds = stage.repetitions * (std::min(stage.duration, fall) + stage.relaxation);
      estimate.longest_seconds += stage.repetitions * (stage.duration + stage.relaxation);
      packed = at_rest_below;
    } else {
      estimate.longest_seconds += stage.duration;
      if (stage.kind == StageKind::settle) {
        settling_seconds += seconds;
        if (stage.dry) dry_seconds += seconds;
        packed = !stage.dry;
      } else {
        packed = stage.superficial_velocity > 0.0 ? stage.superficial_velocity <= packed_velocity : at_rest_below;
      }
    }
    estimate.simulated_seconds += seconds;
    if (packed) packed_seconds += seconds;
  }
  const double spheres = static_cast<double>(estimate.spheres + (dropping ? 1 : 0));
  const double moves = spheres / scene.contact.time_step;
  estimate.particle_steps = std::llround(moves * estimate.simulated_seconds);
  estimate.dry_steps = std::llround(moves * dry_seconds);
  estimate.packed_steps = std::llround(moves * packed_seconds);
  estimate.exchange_steps = std::llround(spheres * (estimate.simulated_seconds - dry_seconds) / scene.fluid.time_step);
  estimate.cell_steps = std::llround(static_cast<double>(estimate.liquid_cells) *
                                     (estimate.simulated_seconds - settling_seconds) / scene.fluid.time_step);
  const Coupling& coupling = scene.coupling;
  if (scene.fluid.tier != FluidTier::quiescent && coupling.void_fraction == VoidFractionScheme::particle_meshing) {
    const double steps_per_interval =
        std::max(1.0, std::round(coupling.void_fraction_interval / scene.fluid.time_step));
    estimate.piece_steps =
        std::llround(coupling.meshing_pieces * static_cast<double>(estimate.exchange_steps) / steps_per_interval);
  }
  if (scene.fluid.pressure_velocity == PressureVelocity::simple && scene.fluid.tier == FluidTier::three_dimensional)
    estimate.simple_steps = estimate.cell_steps;
  if (coupling.disturbance_correction) estimate.disturbance_steps = estimate.exchange_steps;
  if (coupling.added_mass > 0.0) estimate.added_mass_steps = estimate.exchange_steps;
  const CostPerCount cost;
  const std::int64_t loose_steps = estimate.particle_steps - estimate.dry_steps - estimate.packed_steps;
  estimate.core_seconds =
      cost.dry * static_cast<double>(estimate.dry_steps) + cost.packed * static_cast<double>(estimate.packed_steps) +
      cost.loose * static_cast<double>(loose_steps) + cost.exchange * static_cast<double>(estimate.exchange_steps) +
      cost.cell * static_cast<double>(estimate.cell_steps) + cost.piece * static_cast<double>(estimate.piece_steps) +
      cost.simple * static_cast<double>(estimate.simple_steps) +
      cost.disturbance * static_cast<double>(estimate.disturbance_steps) +
      cost.added_mass * static_cast<double>(estimate.added_mass_steps);
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
