#pragma once

#include <vector>

#include "experiments/readings/collect.hpp"

namespace slfb::most_likely {

/// The printed numbers by which readings of the paper are told apart: the packed bed (height and solid fraction, the
/// line of Fig. 5) to choose by, V_2 and the time to the window (Table 2), forces and collisions to test. The voidages
/// of Fig. 13 are disputed: they are those of Eq. 36.
std::vector<readings::Evidence> evidence();

}  // namespace slfb::most_likely
