#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 7: height of the steel sphere against time around minimum fluidisation.
Figure fig07();

}  // namespace slfb
