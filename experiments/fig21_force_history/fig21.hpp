#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 21: collision force in time at six voidages.
Figure fig21();

}  // namespace slfb
