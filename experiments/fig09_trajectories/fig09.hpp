#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 9: height of the steel sphere against time, and the straight lines through it.
Figure fig09();

}  // namespace slfb
