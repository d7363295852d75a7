#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 8: history of the steel sphere at U_L = 0.10 m/s.
Figure fig08();

}  // namespace slfb
