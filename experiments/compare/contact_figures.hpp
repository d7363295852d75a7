#pragma once

#include <filesystem>
#include <vector>

#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/contact_study.hpp"

namespace slfb::compare {

/// Draws one collision, restitution, duration and peak force over the speed, the oblique impact, and the bounce in a
/// liquid.
std::vector<Picture> draw_contact_pictures(const std::vector<ComparedContactLaw>& laws,
                                           const std::vector<ContactFindings>& findings,
                                           const std::filesystem::path& folder);

}  // namespace slfb::compare
