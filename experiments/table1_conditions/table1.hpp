#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Table 1: conditions of the paper, those used here, and what does not add up.
Figure table1();

}  // namespace slfb
