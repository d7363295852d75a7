#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 1: the meshing template, and how far each void-fraction scheme is from exact overlap at what cost.
Figure fig01();

}  // namespace slfb
