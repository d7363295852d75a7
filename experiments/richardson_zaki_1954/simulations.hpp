#pragma once

#include <vector>

#include "experiments/runs/campaign.hpp"

/// The simulations of the beds.
namespace slfb::richardson_zaki {

/// quick: every bed in three dimensions at the velocities of voidage 0.5, 0.7 and 0.9, and as a slice at those of five
/// voidages; full: all in three dimensions, and boxes of another width; laws: slices with drag laws that are near.
std::vector<Profile> profiles();

/// Variant of the slices, and of the boxes that are as narrow as slices; columns and boxes of ten diameters have none.
inline constexpr const char* one_dimensional = "one-dimensional";
inline constexpr const char* in_narrower_box = "narrower-box";

}  // namespace slfb::richardson_zaki
