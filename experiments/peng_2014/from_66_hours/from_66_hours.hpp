#pragma once

#include "experiments/figures/figure.hpp"

namespace slfb {

/// From the paper's 66 hours to ours, one change at a time: what each saves and what it costs in each quantity.
Figure from_66_hours();

}  // namespace slfb
