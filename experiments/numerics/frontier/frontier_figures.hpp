#pragma once

#include <vector>

#include "experiments/figures/figure.hpp"

namespace slfb {

/// The work-precision charts of all studies, the maps of all methods, and pages that are read off them: from 66 hours
/// to ours, the knees of the defaults, what follows for the paper, where less is enough, the plan of each figure. Drawn
/// from this machine's results or else the committed ones.
std::vector<Figure> study_figures();

}  // namespace slfb
