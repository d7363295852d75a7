#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Table 2: straight lines fitted to the fall through the window.
Figure table2();

}  // namespace slfb
