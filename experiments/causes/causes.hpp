#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/claims.hpp"
#include "experiments/figure.hpp"

namespace slfb {

/// What one change of the scene, at otherwise equal settings, does to the quantities of the bed and of the sphere that
/// falls through it: the runs of profile causes and those of drag-law that change one thing, over the unchanged scene.
Figure causes();

/// Adds to the reason of each claim that is not reproduced which single changes would bring it inside the paper's band,
/// with their runs as evidence; nothing where no run says so. `results`: folder of runs/.
void name_causes(std::vector<Evaluation>& evaluations, const std::filesystem::path& results);

}  // namespace slfb
