#pragma once

#include <vector>

#include "experiments/quantities/measurement.hpp"
#include "experiments/quantities/quantity.hpp"
#include "experiments/runs/campaign.hpp"

/// From finished runs to the numbers that claims and figures compare.
namespace slfb {

/// Runs of different models (friction, drag law, grid, …; not seeds, times, steps, springs or the height of the column)
/// are no samples of one number. Of the runs of one key those stay whose model is nearest to the scene file of their
/// work; the others are returned.
std::vector<FinishedRun> take_out_other_models(std::vector<FinishedRun>& runs,
                                               const MeasuringRules& rules = general_rules());

/// Everything that the rules measure in finished runs.
///
/// Runs of one key (run_key) and different names are replicates: their drops are pooled, and the means of their beds
/// are weighted by their intervals. Runs of an older numerics version count only where the key has no current run.
/// Numbers of one run stand under measure_key(quantity, system, U_L, variant), those of all runs of a system without
/// variant under {quantity, system}, those of all systems under {quantity, all_systems}, and what the rules read at a
/// voidage under measure_key("QUANTITY_at_voidage", system, voidage).
Measurements measure_runs(const std::vector<FinishedRun>& runs, const MeasuringRules& rules = general_rules());

/// Takes what depends on the contact stiffness from `of_the_scene`, measured in runs with the stiffness of the scene,
/// where `measurements`, those of other runs, have softened springs. A system changes over as a whole, once two
/// velocities of it are there, so that trends are of one kind; Measurement::springs says of which, so that claims do
/// not compare a system of one kind with one of the other. Variants stay as they are.
void take_contacts_from(const Measurements& of_the_scene, const MeasuringRules& rules, Measurements& measurements);

}  // namespace slfb
