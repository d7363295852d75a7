#pragma once

#include <array>
#include <vector>

#include "experiments/runs/campaign.hpp"

/// The simulations of the beds.
namespace slfb::richardson_zaki {

/// quick: every bed in three dimensions at the velocities of quick_voidages, and as a slice at those of five voidages;
/// full: all in three dimensions, and boxes of another width; laws: as quick in three dimensions with each of
/// near_laws.
std::vector<Profile> profiles();

inline constexpr std::array quick_voidages{0.5, 0.7, 0.9};

/// Beside the law of the scenes: the next ones of `slfb league` without the wall's part, and the most used one. Their
/// runs are variants of these names.
inline constexpr std::array<const char*, 4> near_laws{"syamlal-obrien-1993", "di-felice-1994", "wen-yu-1966",
                                                      "gidaspow-1994"};

/// Variant of the slices, and of the boxes that are as narrow as slices; columns and boxes of ten diameters have none.
inline constexpr const char* one_dimensional = "one-dimensional";
inline constexpr const char* in_narrower_box = "narrower-box";

}  // namespace slfb::richardson_zaki
