#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/laws/scene_file.hpp"

/// No more model than a scene and the quantities asked of it need.
namespace slfb::plan {

/// A rule of rules.toml.
struct Rule {
  struct Condition {
    std::string number;
    bool above;
    double value;
  };
  std::string subject, choice, why, source, evidence, richer;
  std::vector<Condition> when;
  std::vector<std::string> asked, only, set, richer_set;
  std::map<std::string, double> effect;      ///< relative error by quantity [-]
  double steps_per_contact = 0.0;            ///< 0: says nothing of the solid step
  double liquid_steps_per_relaxation = 0.0;  ///< 0: says nothing of the liquid step
  double longest_liquid_step = 0.0;          ///< however long the relaxation takes [s]

  /// A tier that changes nothing of the scene answers by a formula.
  [[nodiscard]] bool without_simulation() const { return subject == "tier" && set.empty(); }
};

/// Whether the plan chooses the forces of the liquid beside drag and pressure gradient, or leaves those of the scene,
/// as for a paper that is to be reproduced.
enum class Forces { planned, of_the_scene };

struct Rules {
  std::vector<std::string> forces;      ///< subjects of such forces
  std::map<std::string, double> bands;  ///< relative error that an answer may have, by quantity [-]
  std::vector<Rule> list;
};

/// \throws std::runtime_error with file, line and key
Rules load_rules();

/// Dimensionless numbers, and a few lengths of time, by which the rules go. In the order in which they are printed.
struct Number {
  std::string name;
  double value;
  std::string meaning;
};
std::vector<Number> numbers_of(const Scene& scene);

struct Decision {
  std::string subject, choice, why, source, evidence;
  Overrides overrides;                   ///< of the scene
  std::map<std::string, double> effect;  ///< on the asked quantities, estimated [-]
  std::string richer;                    ///< empty: none
  Overrides richer_overrides;            ///< what the next richer choice changes in the planned scene
  double richer_core_seconds = 0.0;      ///< of the whole run then
};

struct Plan {
  std::vector<std::string> asked;
  std::vector<Number> numbers;
  std::vector<Decision> decisions;
  Overrides overrides;                   ///< all of them, in order
  bool by_formula = false;               ///< the tier needs no simulation
  double core_seconds = 0.0;             ///< estimated
  double given_core_seconds = 0.0;       ///< of the scene as it stands
  std::map<std::string, double> effect;  ///< on each asked quantity, root of the sum of squares [-]
  std::map<std::string, double> band;    ///< allowed [-]
};

/// \throws std::invalid_argument for a quantity that the rules do not know, listing the known ones
Plan make_plan(const Scene& scene, const std::vector<std::string>& asked, const Rules& rules,
               Forces forces = Forces::planned);

/// The quantities that are asked of a scene when nothing is said: those of its drops, or of its bed.
std::vector<std::string> usual_questions(const Scene& scene);

/// Scene with overrides on top.
Scene changed(const Scene& scene, const Overrides& overrides);

/// Answers of a plan that needs no simulation, by the drag law's root or by CVODE.
std::map<std::string, double> answer_by_formula(const Scene& scene, const Plan& plan);

}  // namespace slfb::plan
