#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "solver/laws/scene_file.hpp"

/// Small numerical experiments that studies and maps repeat with other settings.
namespace slfb::studies {

/// Numbers of a problem that no scene has ("steps_per_contact", "tolerance"); set by "problem.NAME=value".
using Parameters = std::map<std::string, double>;

/// What one trial found for one quantity.
struct TrialValue {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< SI
  /// Root mean square deviation from the exact answer, where the problem knows it; NaN otherwise, same unit.
  double error = std::numeric_limits<double>::quiet_NaN();
  double exact = std::numeric_limits<double>::quiet_NaN();  ///< that answer
};

struct TrialResult {
  std::map<std::string, TrialValue> values;
  std::map<std::string, double> counts;  ///< what no machine changes, per unit of work: "particle-steps", ...
  double cpu_seconds = 0.0;              ///< per unit of work; what that is, the problem says
  std::string failure;                   ///< why there are no values; empty if there are
  std::string machine;
};

struct ProblemQuantity {
  std::string name;   ///< as in a study's file
  std::string title;  ///< for axes
  std::string unit;
};

/// Something with an answer that depends on the numerics.
struct Problem {
  std::string name;
  std::string description;
  std::string cost_unit;  ///< of cpu_seconds and counts: "simulated second", "contact"
  std::string scene;      ///< file in experiments/ that the settings change
  std::vector<ProblemQuantity> quantities;
  Parameters parameters;  ///< those that may be set, with their defaults
  TrialResult (*solve)(const Scene& scene, const Parameters& parameters, int replicate);
};

const std::vector<Problem>& problems();
/// \throws std::invalid_argument that lists the known ones
const Problem& find_problem(const std::string& name);
/// \throws std::invalid_argument that lists the known ones
const ProblemQuantity& find_quantity(const Problem& problem, const std::string& name);

/// A problem and the settings that it is solved with: "contact.stiffness=1e3 N/m" of its scene, "problem.NAME=value".
struct Trial {
  std::string problem;
  std::vector<std::string> settings;
  int replicate = 0;  ///< another start of the same, for statistics

  /// Throws SceneError or std::invalid_argument naming the setting that is wrong.
  void check() const {
    (void)scene();
    (void)parameters();
  }
  [[nodiscard]] Scene scene() const;
  [[nodiscard]] Parameters parameters() const;
  /// Sixteen hexadecimal digits of everything that the answer depends on, numerics version included.
  [[nodiscard]] std::string hash() const;
};

/// Solves the problem on the calling thread. A method that breaks down (std::runtime_error) is an answer: its reason is
/// kept in `failure`. Throws SceneError or std::invalid_argument for wrong settings.
TrialResult solve(const Trial& trial);

/// `text` with every {} replaced by a number: the settings of an axis.
std::string fill_in(std::string text, double value);

}  // namespace slfb::studies
