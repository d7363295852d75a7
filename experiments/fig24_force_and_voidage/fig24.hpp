#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 24: collision force against the voidage, and the correlation fitted to it.
Figure fig24();

}  // namespace slfb
