#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 26: collision force of the eight systems against Eq. 40.
Figure fig26();

}  // namespace slfb
