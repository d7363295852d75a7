#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/numerics/plan/rules.hpp"
#include "solver/laws/scene_file.hpp"

/// No more model than a scene and the quantities asked of it need.
namespace slfb::plan {

/// Whether the plan chooses the forces of the liquid beyond drag and pressure gradient, or leaves those of the scene,
/// as for a work that is to be reproduced.
enum class Forces { planned, of_the_scene };

/// A number of a scene that the conditions of rules look at.
struct Number {
  std::string name;  ///< as in rules.toml
  double value;      ///< dimensionless, or in the SI unit that `meaning` says
  std::string meaning;
};

/// All numbers of a scene, in the order in which they are printed.
/// \throws std::runtime_error where the spheres of the bed do not sink in the liquid
std::vector<Number> numbers_of(const Scene& scene);

/// What a plan chooses for one subject.
struct Decision {
  std::string subject, choice, why = {}, source = {}, evidence = {};  ///< of the rule
  Overrides overrides = {};                                           ///< of the scene
  Part part = Part::model;                                            ///< what kind of error it makes
  std::map<std::string, double> studied = {};  ///< effect on the asked quantities in the studies' scenes [-]
  std::map<std::string, double> effect = {};   ///< the same in this scene, larger where no study reaches it [-]
  std::vector<Beyond> beyond = {};             ///< numbers of this scene that the studies do not reach
  std::string richer = {};                     ///< the next richer choice; empty: none
  Overrides richer_overrides = {};             ///< what it changes in the planned scene
  double richer_core_seconds = 0.0;            ///< of the whole run then, estimated [s]
};

struct Plan {
  std::vector<std::string> asked;
  std::vector<Number> numbers;
  std::vector<Decision> decisions;
  Overrides overrides;                   ///< all of the scene, in order
  bool by_formula = false;               ///< the tier needs no simulation
  double core_seconds = 0.0;             ///< CPU time of the planned run, estimated [s]
  double given_core_seconds = 0.0;       ///< of the scene as it stands [s]
  std::map<std::string, double> effect;  ///< on each asked quantity, root of the sum of squares [-]
  std::map<std::string, double> band;    ///< that it may have [-]

  /// "archimedes_number 120 (studies: 1.5e6): tier, lift": what the studies do not reach, and whose rules say so.
  [[nodiscard]] std::vector<std::string> not_covered() const;
};

/// Goes through the rules for the quantities `asked`. Choices are made by the effects in the scenes of the studies;
/// where these do not reach the scene, the errors of the plan are larger (effect_beyond). Where errors together leave
/// the band of a quantity, the choice with the largest share that a later rule of its subject improves gives way, until
/// all are inside or nothing improves. \throws std::invalid_argument for a quantity that the rules do not know, with a
/// list of the known ones; std::runtime_error as numbers_of, and for a condition on a number that does not exist;
/// SceneError where the planned scene is not valid
Plan make_plan(const Scene& scene, const std::vector<std::string>& asked, const Rules& rules,
               Forces forces = Forces::planned);

/// What a run measures (general_quantities) for each quantity of the rules; not for those that no run answers.
const std::map<std::string, std::string>& measured_names();

/// The quantities that are asked of a scene by default: those of its drops, or of its bed, or of a sphere alone.
std::vector<std::string> usual_questions(const Scene& scene);

/// The scene with overrides on top. \throws SceneError that names the override that is wrong
Scene changed(const Scene& scene, const Overrides& overrides);

/// An answer that needs no simulation of the scene.
struct FormulaAnswer {
  double value = 0.0;       ///< SI
  double error = 0.0;       ///< relative, of what the formula is given [-]; the plan's `effect` is that of the formula
  std::string remark = {};  ///< what it is given
};

/// Answers of a plan that needs no simulation, by quantity: by the root of the drag law, by CVODE or by the bed's
/// weight. For the minimum fluidisation velocity a part of the bed settles first (settle). Quantities without a formula
/// are left out.
std::map<std::string, FormulaAnswer> answer_by_formula(const Scene& scene, const Plan& plan);

}  // namespace slfb::plan
