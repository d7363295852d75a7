#pragma once

#include <string>
#include <string_view>

#include "solver/scene/scene.hpp"

namespace slfb::studies {

/// How much of a study or map is computed: few values and replicates for a look, or all of them for a result.
enum class Set { quick, full };

inline std::string name_of(Set set) { return set == Set::quick ? "quick" : "full"; }
inline Set set_named(std::string_view name) { return name == "quick" ? Set::quick : Set::full; }

/// What is kept with the answers of a study or map.
struct SolvedSet {
  std::string id;       ///< of the study or map
  std::string set;      ///< "quick" or "full"; empty where nothing is kept
  std::string machine;  ///< model of the processor that its times come from
  std::string date;     ///< of the last change, "2026-11-22"
  int numerics = 0;     ///< numerics version of the solver
};

/// Whether `committed` is shown instead of this machine's `own`: there is no own set, or it is quick and the committed
/// one full and of the current numerics version.
inline bool committed_is_better(const SolvedSet& own, const SolvedSet& committed) {
  return own.set.empty() || (own.set == "quick" && committed.set == "full" && committed.numerics == numerics_version);
}

}  // namespace slfb::studies
