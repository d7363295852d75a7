#pragma once

#include <vector>

#include "experiments/figures/figure.hpp"

namespace slfb {

/// Tables that are read off the studies and maps: the knee that each default sits on, what the steps of the paper
/// change (stability/paper.toml), and where less model is enough and where not (plan/examples.toml).
std::vector<Figure> study_tables();

}  // namespace slfb
