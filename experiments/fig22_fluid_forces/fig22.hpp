#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 22: drag and pressure-gradient force on the steel sphere.
Figure fig22();

}  // namespace slfb
