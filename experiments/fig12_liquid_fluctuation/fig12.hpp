#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 12: fluctuation of the liquid's velocity against the voidage.
Figure fig12();

}  // namespace slfb
