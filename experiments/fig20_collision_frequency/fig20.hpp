#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 20: collision frequency of the eight systems.
Figure fig20();

}  // namespace slfb
