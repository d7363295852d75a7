#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Which drag law and sliding friction bring the bed near the paper's printed voidages, velocities and forces.
Figure drag_law_question();

}  // namespace slfb
