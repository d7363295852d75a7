#pragma once

#include "experiments/compare/comparison_bed.hpp"

namespace slfb::paper {

/// The bed in which `slfb compare` puts laws side by side: the 6 mm steel sphere in 5 mm glass and water, the runs of
/// profile quick and those of its one-dimensional slice, the numbers of Table 2 and Fig. 13, and all claims.
/// Throws std::runtime_error where the claims, the profile or the reference data cannot be read.
compare::ComparisonBed comparison_bed();

}  // namespace slfb::paper
