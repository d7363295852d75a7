#pragma once

#include "experiments/figures/figure.hpp"

namespace slfb {

/// Error against cost of the particle integrators, in impacts on a wall.
Figure frontier_integrators();

}  // namespace slfb
