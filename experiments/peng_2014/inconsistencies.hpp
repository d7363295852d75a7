#pragma once

#include <string>
#include <vector>

/// What does not add up in the paper: each row computed from its printed numbers and the laws.
namespace slfb {

struct Inconsistency {
  std::string id;           ///< "particle_density"
  std::string subject;      ///< "density of the fluidised glass"
  std::string source;       ///< where the paper prints its number
  double paper = 0.0;       ///< the printed number
  double recomputed = 0.0;  ///< what the paper's other numbers, or the law it names, give
  std::string unit;
  std::string explanation;  ///< one sentence with every number in it computed
};

/// All rows, in the order of the paper.
std::vector<Inconsistency> inconsistencies();

}  // namespace slfb
