#pragma once

#include <filesystem>
#include <vector>

#include "experiments/claims/claims.hpp"

namespace slfb {

/// Adds to the reason of each claim that is not reproduced which single changes would bring it inside the paper's band,
/// with their runs as evidence; nothing where no run says so. `results`: folder of runs/.
void name_causes(std::vector<Evaluation>& evaluations, const std::filesystem::path& results);

}  // namespace slfb
