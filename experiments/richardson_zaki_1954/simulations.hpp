#pragma once

#include <vector>

#include "experiments/runs/campaign.hpp"

/// The simulations of the beds.
namespace slfb::richardson_zaki {

/// quick: every bed as a slice, at the velocities of five voidages, and in three dimensions at one; laws: slices with
/// drag laws that are near; full: columns and boxes at all five, with and without the wall or in wider boxes.
std::vector<Profile> profiles();

}  // namespace slfb::richardson_zaki
