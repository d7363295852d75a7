#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slfb::plan {

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
  std::vector<std::string> asked;            ///< one of these quantities must be asked for; empty: any
  std::vector<std::string> only;             ///< no other quantity may be asked for; empty: any
  std::vector<std::string> set;              ///< values of the scene that the choice sets, "contact.stiffness=1e3 N/m"
  std::map<std::string, double> effect;      ///< relative error by quantity [-]; none: the choice does not change it
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
  std::vector<Rule> list;
};

/// Reads rules.toml, and the effects that it refers to from the committed results of the studies.
/// \throws std::runtime_error with file, line and key
Rules load_rules();
/// The same from another file.
Rules load_rules(const std::filesystem::path& file);

}  // namespace slfb::plan
