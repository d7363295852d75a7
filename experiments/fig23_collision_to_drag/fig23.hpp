#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 23: collision force over drag.
Figure fig23();

}  // namespace slfb
