#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/drag_study.hpp"

/// Drag laws in the report of a comparison.
namespace slfb::compare {

/// Laws, pictures, ratios to the literature, properties and the homogeneous bed, for the page of the comparison; draws
/// into `folder`/figures. `findings` and `candidates` are those of `laws`, in the same order.
std::vector<Section> drag_sections(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                                   const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                   const std::filesystem::path& folder);

/// The time of one evaluation of each law, for the section of costs (HTML).
std::string evaluation_cost_html(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings);

/// An array with name, time of one evaluation [s], minimum fluidisation velocity [m/s], properties, the homogeneous bed
/// and the ratios to the literature, for each law.
nlohmann::ordered_json drag_json(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                                 const ComparisonBed& bed);

}  // namespace slfb::compare
