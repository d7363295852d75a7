#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 15: the steel sphere on its way through 3 mm glass at three voidages.
Figure fig15();

}  // namespace slfb
