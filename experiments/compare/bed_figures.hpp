#pragma once

#include <filesystem>
#include <vector>

#include "experiments/compare/candidates.hpp"
#include "experiments/compare/comparison_page.hpp"

namespace slfb::compare {

/// What the candidates' runs have measured beside the paper and the correlations: classification velocity, collision
/// force and collision frequency of the 6 mm steel sphere. None without a run.
std::vector<Picture> draw_bed_pictures(const std::vector<Candidate>& candidates, const std::filesystem::path& folder);

/// Plot elements for the points of each candidate, ", '…' … title …", their table written into `folder`: x and y with
/// the half widths of their 95 % intervals, by superficial velocity. `x` empty: the superficial velocity itself.
std::string simulated_points(const std::string& id, const std::vector<Candidate>& candidates, const std::string& x,
                             const std::string& y, const std::string& y_unit, const std::filesystem::path& folder);

}  // namespace slfb::compare
