#pragma once

#include "experiments/figures/figure.hpp"

namespace slfb {

/// Collision frequency of an elastic gas of spheres against kinetic theory, Eqs. 6 and 7 of the paper.
Figure kinetic_theory();

}  // namespace slfb
