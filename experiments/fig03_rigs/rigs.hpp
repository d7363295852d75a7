#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 3: the rig of the settling experiments, drawn from the paper's description.
Figure fig03();

/// Figure 4: the same column with particle image velocimetry.
Figure fig04();

}  // namespace slfb
