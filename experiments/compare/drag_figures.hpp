#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/compare/candidates.hpp"
#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/drag_study.hpp"

namespace slfb::compare {

/// Draws the surfaces of the laws, their ratio to each law of the literature, the expansion of the bed and the
/// classification velocity, the latter with what the candidates' runs have measured.
std::vector<Picture> draw_drag_pictures(const std::vector<ComparedDragLaw>& laws,
                                        const std::vector<Candidate>& candidates, const std::filesystem::path& folder);

}  // namespace slfb::compare
