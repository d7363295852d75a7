#pragma once

#include "experiments/figure.hpp"

namespace slfb {

/// Are the paper's voidages those of its simulated beds? The collision force over the voidage of our own bed, and over
/// the one that Eq. 36 gives for a homogeneous bed at the same superficial velocity, each against Eq. 40.
Figure printed_voidage();

}  // namespace slfb
