#pragma once

#include "experiments/numerics/studies/trial.hpp"

/// One problem a file; see the descriptions there.
namespace slfb::studies {

Problem impact_problem();
Problem swing_problem();
Problem packing_problem();
Problem gas_problem();
Problem relaxation_problem();
Problem fall_problem();
Problem fall_by_root_problem();
Problem fall_by_ode_problem();
Problem bed_box_problem();
Problem bed_weight_problem();
Problem bed_slice_problem();
Problem bed_by_root_problem();
Problem bed_by_ode_problem();
Problem void_fraction_problem();
Problem fullest_cell_problem();
Problem vortices_problem();
Problem pressure_window_problem();
Problem homogeneous_bed_problem();
Problem late_reaction_problem();

}  // namespace slfb::studies
