#pragma once

#include <filesystem>
#include <vector>

#include "reports/report_contents.hpp"

namespace slfb::reports {

/// Draws parity.svg, .png and .pdf into `folder`, with its table and script: for every claim that states a number and
/// has one of ours, ours over the paper's with its 95 % interval, a row for each place in the work. What lies outside a
/// factor of ten stands at the edge as an arrow. Returns false, and draws nothing, where there is no such claim. Errors
/// as draw_plot.
bool draw_parity(const std::vector<ClaimRow>& claims, const std::filesystem::path& folder);

}  // namespace slfb::reports
