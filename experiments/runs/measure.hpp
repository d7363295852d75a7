#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/quantities/measurement.hpp"
#include "experiments/runs/campaign.hpp"

/// From finished runs and from the laws to the numbers that the claims and figures compare.
namespace slfb {

/// True when `key` is answered by simulations (its subject is a system such as 6in5W, or all), false for laws.
bool needs_run(const MeasureKey& key);

/// Everything measured in finished runs.
///
/// Runs of one key and different names are replicates: their drops are pooled. Runs of an older numerics version count
/// only where the key has no current run. Quantities per run: classification_velocity, classification_intercept (on the
/// paper's clock: release at 20 s, NaI 30 s) and time_to_bottom of drops from the paper's height, bottom_fraction,
/// falling_after_15_s and _30_s, classification_r2, voidage_centre_of_mass, voidage_bed_top, bed_top, pressure_drop,
/// packed_voidage, packed_height, stokes_number, liquid_fluctuation, liquid_fluctuation_vertical, fluctuating_energy,
/// local_fluctuating_energy, contacts_per_particle, collision_frequency, dimensionless_collision_frequency, ktgf_ratio,
/// collision_force_ratio, collision_force_ratio_of_mean, equation_40_deviation, collision_to_drag_ratio, drag_ratio,
/// pressure_gradient_ratio, mean_contacts, maximum_contacts, contact_fraction, peak_force_ratio, lateral_travel,
/// local_voidage_mean, local_voidage_minimum, local_voidage_maximum, terminal_velocity, terminal_reynolds, penetration,
/// maximum_overlap_mean, plane_voidage_deviation, plane_vorticity_range, plane_speed_maximum, particles_removed,
/// wall_seconds_per_simulated_second.
///
/// Quantities per system, "quantity/system", from all its runs without variant: packed_line_slope,
/// packed_line_intercept, pressure_plateau, minimum_fluidisation_velocity, classification_velocity_rise_ratio. Where
/// the paper gives a voidage instead of U_L: "quantity_at_voidage/system/0.45" for collision_frequency, drag_ratio,
/// lateral_travel, liquid_fluctuation, maximum_contacts, mean_contacts and pressure_gradient_ratio, on straight lines
/// between the runs. Of all systems together: equation_40_share_within_10_percent/all.
Measurements measure_runs(const std::vector<FinishedRun>& runs);

/// What a softer spring gets wrong, for its contacts last longer and hide the next: counts of contacts and collisions,
/// and single forces, also "…_at_voidage".
bool depends_on_contact_stiffness(std::string_view quantity);

/// Takes what hangs on the springs from `own_springs`, measured in runs with those of the scene
/// (runs_with_own_springs). A system
/// changes over as a whole, once two velocities of it are there, so that trends are of one kind; Measurement::springs
/// says of which, so that claims do not compare a system of one kind with one of the other.
void take_contacts_from(const Measurements& own_springs, Measurements& measurements);

/// Everything that follows from the literature laws and the reference data alone ("quantity/what").
Measurements measure_laws();

/// All that needs no simulated bed: measure_laws and measure_probes.
Measurements measure_without_runs();

/// What claims and figures are held against: all that needs no run, these runs, and contacts from those with the
/// scene's own springs in `out`/runs or committed.
Measurements measure_all(const std::vector<FinishedRun>& runs, const std::filesystem::path& out);

}  // namespace slfb
