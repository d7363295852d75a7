#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/contact_study.hpp"

/// Contact laws in the report of a comparison.
namespace slfb::compare {

/// Laws, collisions of two bodies, properties, and what the candidates' runs measured beside the correlations, for the
/// page of the comparison; draws into `folder`/figures. `findings` and `candidates` are those of `laws`, in the same
/// order.
std::vector<Section> contact_sections(const std::vector<ComparedContactLaw>& laws,
                                      const std::vector<ContactFindings>& findings,
                                      const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                      const std::filesystem::path& folder);

/// The time of one contact under each law, for the section of costs (HTML).
std::string contact_cost_html(const std::vector<ComparedContactLaw>& laws,
                              const std::vector<ContactFindings>& findings);

/// An array with name, overrides, time of one contact [s], what the usual collision at 0.1 m/s gives (SI units) and the
/// properties, for each law.
nlohmann::ordered_json contact_json(const std::vector<ComparedContactLaw>& laws,
                                    const std::vector<ContactFindings>& findings);

}  // namespace slfb::compare
