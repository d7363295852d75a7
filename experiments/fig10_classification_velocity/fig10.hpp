#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 10 and Table 2: classification velocity against the superficial velocity.
Figure fig10();

}  // namespace slfb
