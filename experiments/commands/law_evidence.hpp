#pragma once

#include <optional>
#include <string>

#include "experiments/league/scene_bed.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {

/// What measured beds near that of a scene say of laws, its own among them also where that is a file of the user
/// or has parameters.
struct LawEvidence {
  std::vector<league::Contender> contenders;  ///< that `found` points into
  std::optional<league::Recommendation> found;

  explicit LawEvidence(const Scene& scene);
  LawEvidence(const LawEvidence&) = delete;
  LawEvidence& operator=(const LawEvidence&) = delete;
};

/// "rong-2013, typically within 12 % of the velocity, at most 22 %".
std::string evidence_text(const league::Evidence& evidence);

}  // namespace slfb
