#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace slfb::studies {

/// What is kept with the answers of a study or map: which set of it, where, when and with which numerics.
struct SolvedSet {
  std::string id, set, machine, date;  ///< set: "quick" or "full"; empty where nothing is kept
  int numerics = 0;
};

/// Whether this machine's set gives way to the committed one: there is none, or it is quick and the other full.
inline bool stands_behind(const SolvedSet& own, const SolvedSet& committed) {
  return own.set.empty() || (own.set == "quick" && committed.set == "full" && committed.numerics == numerics_version);
}

}  // namespace slfb::studies
