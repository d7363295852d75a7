#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/contact_study.hpp"

namespace slfb::compare {

/// Laws, collisions of two bodies, properties, and what the candidates' runs measured beside the correlations; draws
/// into `folder`/figures.
std::vector<Section> contact_sections(const std::vector<ComparedContactLaw>& laws,
                                      const std::vector<ContactFindings>& findings,
                                      const std::vector<Candidate>& candidates, const std::filesystem::path& folder);

/// The time of one contact, for the costs.
std::string contact_cost_html(const std::vector<ComparedContactLaw>& laws,
                              const std::vector<ContactFindings>& findings);

nlohmann::ordered_json contact_json(const std::vector<ComparedContactLaw>& laws,
                                    const std::vector<ContactFindings>& findings);

}  // namespace slfb::compare
