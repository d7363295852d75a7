#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 19: dimensionless collision frequency against the kinetic theory.
Figure fig19();

}  // namespace slfb
