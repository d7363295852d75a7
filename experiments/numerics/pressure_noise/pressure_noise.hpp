#pragma once

#include "experiments/figures/figure.hpp"

namespace slfb {

/// Fluctuation of the instantaneous pressure drop against the liquid's time step, for every void-fraction scheme.
Figure pressure_noise();

}  // namespace slfb
