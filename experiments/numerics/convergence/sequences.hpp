#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/numerics/convergence/grid_convergence.hpp"

/// Results at several cells or steps, from the studies of frontier/.
namespace slfb::convergence {

/// What is refined.
enum class Refined { cells, liquid_step, solid_step };

/// One quantity over the levels of one bed.
struct QuantitySequence {
  std::string quantity;       ///< "voidage", by the names of frontier/'s problems
  std::vector<Level> levels;  ///< of which something is known
};

/// A bed that was simulated at several levels.
struct Sequence {
  std::string title;
  Refined refined = Refined::cells;
  std::vector<QuantitySequence> quantities;
};

/// The sequences of sequences.toml, with what is known of the studies (frontier::load_reduced of `results`).
/// \throws std::runtime_error with file, line and key
std::vector<Sequence> study_sequences(const std::filesystem::path& results);

/// "cells", "liquid-step" or "solid-step", as the files have it.
/// \throws std::invalid_argument for another word, with a list of these
Refined refined_by_name(const std::string& name);

/// "cells", "liquid step" or "contact step", for titles.
std::string name_of(Refined refined);
/// A size in the unit of its kind: "7.1 mm", "0.05 ms".
std::string size_text(Refined refined, double size);

}  // namespace slfb::convergence
