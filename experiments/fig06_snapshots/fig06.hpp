#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 6: the bed at the end of the fall around minimum fluidisation.
Figure fig06();

}  // namespace slfb
