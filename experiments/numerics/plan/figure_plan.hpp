#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/numerics/plan/plan.hpp"

/// The plan of each figure of a work: the cheapest model that answers what is asked of its simulations, and what the
/// published numerics and the profile that the figure draws take beside it.
namespace slfb::plan {

/// What a figure asks of which run: a block [[figure]] of a file of a work.
struct FigureQuestion {
  std::string figure;              ///< "fig10"
  std::vector<std::string> asked;  ///< quantities of rules.toml
  Overrides scene;                 ///< what the figure changes in the scene of the work
  std::string run;                 ///< key of the run that it draws
  bool fields = false;             ///< it draws the liquid's fields, so that it needs three dimensions
};

/// \throws std::runtime_error with file, line and key
std::vector<FigureQuestion> load_questions(const std::filesystem::path& file);

struct FigurePlan {
  std::string figure;
  std::vector<std::string> asked;
  std::string tier, steps;              ///< of the planned scene, in words
  bool by_formula = false;              ///< nothing has to be simulated
  double error_over_band = 0.0;         ///< of the asked quantity for which it is largest, as the rules estimate it [-]
  std::string worst;                    ///< that quantity
  double core_seconds = 0.0;            ///< of the planned scene, estimated CPU time per simulated second [-]
  double published_core_seconds = 0.0;  ///< of the same with the published mesh and steps [-]
  double profile_core_seconds = 0.0;    ///< of the run that the figure draws [-]
  std::string profile;                  ///< that has this run
  std::string agreement;  ///< of this run with the plan: "as planned", "coarser: stiffness", "richer: tier"
};

/// Plans a figure with the forces of its scene.
/// \param scene of the work, with the changes of the question
/// \param published the same with the published mesh and steps
/// \param simulated scene of the run that the figure draws, and the profile that has it
/// \throws what make_plan throws
FigurePlan plan_figure(const FigureQuestion& question, const Scene& scene, const Scene& published,
                       const Scene& simulated, const std::string& profile, const Rules& rules);

/// As text for a terminal, two lines a figure under a heading.
std::string figure_plans_text(const std::vector<FigurePlan>& plans);

}  // namespace slfb::plan
