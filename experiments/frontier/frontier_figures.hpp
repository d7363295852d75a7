#pragma once

#include <vector>

#include "experiments/figure.hpp"

namespace slfb {

/// The work-precision charts of all studies, the maps of all methods, and two pages: from 66 hours to ours, and the
/// knee that each default sits on. Drawn from this machine's results or else the committed ones.
std::vector<Figure> study_figures();

}  // namespace slfb
