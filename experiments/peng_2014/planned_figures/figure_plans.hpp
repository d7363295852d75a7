#pragma once

#include <vector>

#include "experiments/numerics/plan/figure_plan.hpp"

namespace slfb {

/// The plans of the paper's figures: what figures.toml asks, with the paper's own mesh and steps, and with the run that
/// the figure draws: of profile quick, or of full where that has no run of the figure.
/// \throws std::runtime_error with file, line and key
std::vector<plan::FigurePlan> figure_plans();

}  // namespace slfb
