#pragma once

#include <filesystem>
#include <vector>

#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/contact_study.hpp"

/// Pictures of contact laws. Each is a table, values, and a gnuplot file of experiments/compare/plots/.
namespace slfb::compare {

/// Draws into `folder` one collision, restitution, duration and peak force over the speed, the oblique impact, and the
/// bounce in the liquid. `findings` are those of `laws`, in the same order. \throws std::runtime_error where a file
/// cannot be written or gnuplot fails
std::vector<Picture> draw_contact_pictures(const std::vector<ComparedContactLaw>& laws,
                                           const std::vector<ContactFindings>& findings, const ComparisonBed& bed,
                                           const std::filesystem::path& folder);

}  // namespace slfb::compare
