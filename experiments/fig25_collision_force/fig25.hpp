#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 25: collision force on the foreign particle against the voidage.
Figure fig25();

}  // namespace slfb
