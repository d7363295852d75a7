#pragma once

#include <filesystem>

#include "experiments/figures/figure.hpp"
#include "experiments/numerics/frontier/study.hpp"

namespace slfb::frontier {

/// Draws frontier-ID: a work-precision chart of every quantity, with the Pareto front in black and what failed as a
/// cross at its cost. Its tables lie beside it. Points of `beside`, this machine's quick set, are open circles.
FigureOutput draw_frontier(const Study& study, const ReducedStudy& reduced, const ReducedStudy& beside,
                           const std::filesystem::path& folder);

}  // namespace slfb::frontier
