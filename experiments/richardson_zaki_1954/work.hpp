#pragma once

#include "experiments/work/work.hpp"

/// Richardson & Zaki (1954), Trans. Instn Chem. Engrs 32, 35: expansion of fluidised beds of spheres in liquids.
namespace slfb {

/// The work, put together once.
const Work& richardson_zaki_1954_work();

}  // namespace slfb
