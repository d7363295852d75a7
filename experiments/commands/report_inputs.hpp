#pragma once

#include <filesystem>
#include <string>

namespace slfb {

/// Sixteen digits of everything that a report is drawn from: the program, its data, the profile, and the results in
/// `out`. Where they are those of the last report, there is nothing to draw.
std::string report_inputs(const std::string& work, const std::string& profile, const std::filesystem::path& out);

}  // namespace slfb
