#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 17: contacts and velocity of the foreign sphere over a tenth of a second.
Figure fig17();

}  // namespace slfb
