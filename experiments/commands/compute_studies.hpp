#pragma once

#include <filesystem>
#include <string>

#include "experiments/numerics/studies/solved_set.hpp"

namespace slfb {

/// Computes what is missing of all studies (`slfb frontier`) and maps (`slfb stability`), `jobs` trials side by side,
/// and keeps the results in `out`, where their figures find them. Shows one display under `heading`. Returns false when
/// a signal (Ctrl-C) stopped it. Throws what studies::solve_missing and stability::solve_map throw.
bool compute_studies(studies::Set set, const std::filesystem::path& out, int jobs, const std::string& heading);

}  // namespace slfb
