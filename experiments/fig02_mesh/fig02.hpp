#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Figure 2: the domain and our mesh.
Figure fig02();

}  // namespace slfb
