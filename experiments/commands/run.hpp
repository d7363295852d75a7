#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// Adds `slfb run SCENE.toml [--out DIR] [--threads N] [--set KEY=VALUE]… [--dry-run] [--json]`.
///
/// `--json` writes one object to standard output. With `--dry-run`: {"scene", "hash", "spheres", "liquid_cells",
/// "steps_per_contact", "dem_time_step", "dem_time_step_bound", "liquid_time_step", "simulated_seconds",
/// "simulated_seconds_at_most", "particle_steps", "estimated_wall_seconds", "result", "result_exists"}; else {"scene",
/// "hash", "status" ("finished", "existed", "interrupted", "failed"), "result", and for a result "wall_seconds",
/// "cpu_seconds", "simulated_seconds", "particle_steps", "particle_steps_per_second", "particles_removed",
/// "measurements": {quantity: {"value", "half_width", "unit", "samples"}}, "drops": [{"species", "release_time",
/// "bottom_time", "classification_velocity", "r_squared"}]}. A number that does not exist is null.
void add_run_command(CLI::App& app);

}  // namespace slfb
