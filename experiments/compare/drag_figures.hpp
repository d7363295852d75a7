#pragma once

#include <filesystem>
#include <vector>

#include "experiments/compare/candidates.hpp"
#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/drag_study.hpp"

/// Pictures of drag laws. Each is a table, values, and a gnuplot file of experiments/compare/plots/.
namespace slfb::compare {

/// Draws into `folder` the laws among the literature, their surfaces, the ratio of each but the first to every law of
/// the literature, and last the expansion of the bed and the classification velocity, the latter with what the
/// candidates' runs have measured. \throws std::runtime_error where a file cannot be written or gnuplot fails
std::vector<Picture> draw_drag_pictures(const std::vector<ComparedDragLaw>& laws,
                                        const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                        const std::filesystem::path& folder);

}  // namespace slfb::compare
