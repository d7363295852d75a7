#pragma once

#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/quantities/measurement.hpp"

namespace slfb {

/// Gates results of another code against those that it accepted before, instead of against the bands of the paper.
///
/// The gate of an evaluation breaks when a measure of its claim differs from the accepted one by more than both 95 %
/// intervals together, or by more than a part in 1e9 where both are exact; the reason says so. It is none where no
/// measure has an accepted one, or where either is a single sample, which has no interval.
void gate_against_baseline(std::vector<Evaluation>& evaluations, const Measurements& now, const Measurements& accepted);

}  // namespace slfb
