#pragma once

#include <string>
#include <vector>

/// The plan of each figure of the paper: what is asked of its simulations (figures.toml), the cheapest rung that
/// answers it, and what the paper's own rung and the profile that the figure draws would take.
namespace slfb::plan {

struct FigurePlan {
  std::string figure;  ///< "fig10"
  std::vector<std::string> asked;
  std::string tier, steps;  ///< in words
  bool by_formula = false;
  double error_over_band = 0.0;  ///< of the asked quantity for which it is largest, as estimated by the rules
  std::string worst;             ///< that quantity
  double core_seconds = 0.0, paper_core_seconds = 0.0,
         profile_core_seconds = 0.0;  ///< estimated, per simulated second; of the figure's scene, the same with the
                                      ///< paper's mesh and steps, and with the profile
  std::string profile;    ///< "springs" for contacts, else "quick", or "full" where that has no run of the figure
  std::string agreement;  ///< of the profile with the plan: "as planned", "coarser: stiffness", "richer: tier"
};

/// \throws std::runtime_error with file, line and key
std::vector<FigurePlan> figure_plans();

/// As text for a terminal, two lines a figure under a heading.
std::string figure_plans_text(const std::vector<FigurePlan>& plans);

}  // namespace slfb::plan
