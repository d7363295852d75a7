#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 11: predicted against measured classification velocity.
Figure fig11();

}  // namespace slfb
