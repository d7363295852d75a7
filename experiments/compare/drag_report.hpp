#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "experiments/compare/comparison_page.hpp"
#include "experiments/compare/drag_study.hpp"

namespace slfb::compare {

/// What is known of one law without a simulation.
struct DragFindings {
  std::vector<PropertyCheck> properties;
  double minimum_fluidisation;    ///< [m/s]
  double seconds_per_evaluation;  ///< [s]
};
std::vector<DragFindings> find_out(const std::vector<ComparedDragLaw>& laws);

/// Laws, pictures, ratios to the literature, properties and the homogeneous bed; draws into `folder`/figures.
std::vector<Section> drag_sections(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings,
                                   const std::vector<Candidate>& candidates, const std::filesystem::path& folder);

/// The time of one evaluation, for the costs.
std::string evaluation_cost_html(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings);

nlohmann::ordered_json drag_json(const std::vector<ComparedDragLaw>& laws, const std::vector<DragFindings>& findings);

}  // namespace slfb::compare
