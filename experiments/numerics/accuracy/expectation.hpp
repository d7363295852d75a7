#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/numerics/plan/plan.hpp"

/// What an asked accuracy takes, before anything runs.
///
/// The accuracy is that of the scene: of its spheres, liquid, contacts and drag law, solved with every model, grid and
/// step that the suite has. How far the drag law itself is from measured beds is another question (`slfb league`).
namespace slfb::accuracy {

struct Goal {
  std::vector<std::string> asked;  ///< quantities of rules.toml
  double error = 0.05;             ///< relative, of each of them [-]
  plan::Forces forces = plan::Forces::planned;
};

/// Parts of a relative error [-]. Those of models and of grid and steps have unknown signs and causes of their own:
/// they add as squares. More samples take away neither, so that the interval adds to them as it is.
struct Parts {
  double model = 0.0, discretisation = 0.0;
  double statistics = 0.0;  ///< half width of the interval

  [[nodiscard]] double systematic() const;
  [[nodiscard]] double total() const { return systematic() + statistics; }
};

/// Relative scatter of one bed and of one drop, by quantity [-].
struct Scatter {
  std::map<std::string, double> bed, drop;
};

/// What a goal takes.
struct Expectation {
  Goal goal;
  plan::Plan plan;
  Scene scene;                                         ///< of the first bed; others have other seeds
  std::map<std::string, Parts> parts;                  ///< by quantity
  std::map<std::string, plan::FormulaAnswer> answers;  ///< nothing is simulated where there are any
  int beds = 0;                                        ///< expected to be enough
  double core_seconds = 0.0;                           ///< of these beds and the check, CPU time [s]
  std::optional<Scene> check;        ///< the scene that the planned one is compared with; empty: no need, or none
  std::vector<std::string> checked;  ///< subjects in which the two differ
  double check_core_seconds = 0.0;   ///< of it [s]
  std::string obstacle;              ///< what keeps the goal out of reach; empty: it is in reach
  double best = 0.0;                 ///< smallest error of models, grid and steps that choices of the plan have [-]

  [[nodiscard]] bool by_formula() const { return plan.by_formula; }
};

/// Fewest beds that an answer rests on: what a bed has of its own shows in others only.
inline constexpr int fewest_beds = 3;

/// Chooses tier, grid, steps, springs, forces, time and drops such that all errors stay below the goal at the least
/// cost. The share of the error that models, grid and steps may have is varied: the rest is left to statistics. Where
/// the studies of a rule do not reach the scene (plan::Decision::beyond), the choice is made by their errors as they
/// are, and a richer scene is set up to check it.
///
/// Where no choice reaches the goal, `obstacle` says why, and the plan is the one with the smallest error.
/// \param scatter measured in this scene; where it has no entry, that of rules.toml is taken
/// \throws std::invalid_argument for quantities that the scene cannot answer, with those that it can; what make_plan
/// throws
Expectation expect(const Scene& scene, const Goal& goal, const plan::Rules& rules, const Scatter& scatter = {});

/// A scene with half the steps and, where they may be that small, cells of four fifths.
Scene refined(const Scene& scene);

/// The scene of a bed: 0 as it is, others with the seeds behind its own.
Scene bed_of(const Scene& scene, int number);

/// Whether the quantity is of the sphere that is dropped rather than of the bed.
bool of_drops(const std::string& quantity);

}  // namespace slfb::accuracy
