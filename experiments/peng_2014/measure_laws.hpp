#pragma once

#include "experiments/quantities/measurement.hpp"

namespace slfb {

/// Everything that follows from the literature laws and the paper's numbers alone: {quantity, law or what it is of}.
Measurements measure_laws();

/// All that needs no simulated bed: measure_laws and measure_probes.
Measurements measure_without_runs();

}  // namespace slfb
