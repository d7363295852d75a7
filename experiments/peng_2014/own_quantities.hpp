#pragma once

#include <vector>

#include "experiments/quantities/quantity.hpp"

namespace slfb::paper {

/// What only this paper measures in runs, and what only its laws, arithmetic and probes give (measure_laws.cpp,
/// probes.cpp).
std::vector<Quantity> own_quantities();

}  // namespace slfb::paper
