#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 5: pressure drop of the bed against the superficial velocity.
Figure fig05();

}  // namespace slfb
