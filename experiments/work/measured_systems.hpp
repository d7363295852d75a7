#pragma once

#include "experiments/claims/records_file.hpp"
#include "experiments/work/work.hpp"

namespace slfb {

/// What results of others refer to in a work: its systems with the scenes of its profiles, and how it measures.
MeasuredSystems measured_systems(const Work& work);

}  // namespace slfb
