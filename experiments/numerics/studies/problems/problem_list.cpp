#include "experiments/numerics/studies/problems/problem_list.hpp"

namespace slfb::studies {

const std::vector<Problem>& problems() {
  static const std::vector<Problem> list{
      impact_problem(),          swing_problem(),           packing_problem(),      gas_problem(),
      relaxation_problem(),      fall_by_root_problem(),    fall_by_ode_problem(),  fall_problem(),
      bed_by_root_problem(),     bed_by_ode_problem(),      bed_box_problem(),      bed_weight_problem(),
      bed_slice_problem(),       void_fraction_problem(),   fullest_cell_problem(), vortices_problem(),
      pressure_window_problem(), homogeneous_bed_problem(), late_reaction_problem()};
  return list;
}

}  // namespace slfb::studies
