#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 18: fluctuating kinetic energy of the fluidised particles.
Figure fig18();

}  // namespace slfb
