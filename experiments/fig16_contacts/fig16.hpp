#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 16: mean and largest number of contacts of the steel sphere in 3 mm glass.
Figure fig16();

}  // namespace slfb
