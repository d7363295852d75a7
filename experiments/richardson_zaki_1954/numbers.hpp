#pragma once

#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/quantities/measurement.hpp"
#include "experiments/quantities/quantity.hpp"
#include "experiments/reference/expansion_lines.hpp"
#include "experiments/reference/reference_numbers.hpp"

/// What Richardson & Zaki (1954) print, what laws say to it, and how near is near.
namespace slfb::richardson_zaki {

/// Values "BED/exponent", "BED/intercept" and "BED/voidage/0.50" of each bed.
const ReferenceNumbers& printed();

/// How far the measured voidage is known [-]: half of what the two columns with the same spheres and liquid differ by
/// at one velocity, the mean over the voidages at which lines are read. The tables say nothing of the points' own
/// scatter.
double voidage_band();

/// The same for the exponent, relative [-].
double exponent_band();

/// n of the runs of a bed, its intercept U_i and what else no general quantity has.
std::vector<Quantity> own_quantities();

/// The voidage of each bed at the superficial velocities of its measured line, and n: by our simulations, by the
/// authors' own formula, and by the drag law of the scenes in a homogeneous bed.
std::vector<Claim> claims();

/// Homogeneous beds of every law of the league at these velocities: "homogeneous_voidage/LAW/U/BED", and n over the
/// voidages from 0.5 to 0.9: "homogeneous_exponent/LAW/BED".
Measurements measure_laws();

/// Name of the authors' own formula in the league.
std::string authors_formula();

/// The drag law of the scenes.
inline constexpr const char* scene_law = "rong-2013";

}  // namespace slfb::richardson_zaki
