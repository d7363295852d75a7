#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 13: void fraction in the plane y = 0.
Figure fig13();

}  // namespace slfb
