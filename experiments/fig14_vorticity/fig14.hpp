#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 14: vorticity, speed and direction of the liquid in the plane y = 0.
Figure fig14();

}  // namespace slfb
