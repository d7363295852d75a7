#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slfb::plan {

/// Where an error comes from: a model that is left out or simplified; grid and steps; few samples.
enum class Part { model, discretisation, statistics };
std::string to_string(Part part);

/// Values of a number of a scene.
struct Range {
  double lowest = 0.0, highest = 0.0;
};

/// A rule of rules.toml; the head of that file explains the keys. Of the rules of one subject the first holds whose
/// conditions are all true.
struct Rule {
  /// On a number that the plan computes (numbers_of).
  struct Condition {
    std::string number;
    bool above;  ///< the number must be above `value`; false: below
    double value;
  };
  std::string subject;  ///< what is decided: "tier", "solid step"
  std::string choice;   ///< in words
  std::string why, source, evidence;
  std::vector<Condition> when;
  std::vector<std::string> asked;        ///< one of these quantities must be asked for; empty: any
  std::vector<std::string> only;         ///< no other quantity may be asked for; empty: any
  std::vector<std::string> set;          ///< values of the scene that the choice sets, "contact.stiffness=1e3 N/m"
  Part part = Part::model;               ///< what kind of error the choice makes
  std::map<std::string, double> effect;  ///< relative error by quantity [-]; none: the choice does not change it
  /// Of the effects that studies have: standard error of the deviation behind each [-].
  std::map<std::string, double> standard_error;
  /// Numbers of the scenes behind the effects, by name; empty where the rule rests on no scene, or holds
  /// in every one (key `anywhere`).
  std::map<std::string, Range> covered;
  std::string richer;                        ///< the next richer choice, in words; empty: none
  std::vector<std::string> richer_set;       ///< values of the scene that it sets
  double steps_per_contact = 0.0;            ///< of the solid step that is chosen [-]; 0: the rule chooses none
  double liquid_steps_per_relaxation = 0.0;  ///< of the liquid step that is chosen [-]; 0: the rule chooses none
  double longest_liquid_step = 0.0;          ///< upper bound of that step [s]

  /// Whether the choice answers by a formula: a tier that sets nothing.
  [[nodiscard]] bool without_simulation() const { return subject == "tier" && set.empty(); }
};

/// What rules.toml says.
struct Rules {
  std::vector<std::string> forces;      ///< subjects that are forces beyond drag and pressure gradient
  std::map<std::string, double> bands;  ///< relative error that an answer may have, by quantity [-]
  /// Which part the error of a subject is, where its rules do not say.
  std::map<std::string, Part> parts;
  /// How far beyond the scenes of its studies a rule is taken to hold: factor on each number that is compared [-].
  std::map<std::string, double> reach;
  /// Standard deviation of one bed about the mean of many, and of one drop, relative, by quantity [-].
  std::map<std::string, double> bed_scatter, drop_scatter;
  std::vector<Rule> list;
};

/// A number of a scene that a rule's studies do not reach.
struct Beyond {
  std::string number;  ///< "archimedes_number"
  double value;        ///< of the scene
  Range covered;       ///< of the studies
  double steps;        ///< how far beyond their reach: the logarithm of the distance over that of the reach [-]
};

/// Where the rule does not reach a scene with these numbers. \param numbers by name
std::vector<Beyond> beyond(const Rule& rule, const Rules& rules, const std::map<std::string, double>& numbers);

/// Error of a rule on a quantity in a scene that its studies do not reach: one more than the steps beyond their reach,
/// times the root of the squares of effect and standard error. A deviation that grows with the logarithm of the
/// distance is the least that can be said; an effect of nothing is known no better than its standard error.
/// \param steps largest of Beyond::steps; 0 inside, where the effect stands as it is
double effect_beyond(const Rule& rule, const std::string& quantity, double steps);

/// Reads rules.toml, and the effects that it refers to from the committed results of the studies.
/// \throws std::runtime_error with file, line and key
Rules load_rules();
/// The same from another file.
Rules load_rules(const std::filesystem::path& file);

}  // namespace slfb::plan
