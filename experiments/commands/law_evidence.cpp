#include "experiments/commands/law_evidence.hpp"

#include <fmt/format.h>

#include "solver/laws/user_law.hpp"

namespace slfb {

LawEvidence::LawEvidence(const Scene& scene) : contenders(league::contenders()) {
  std::string of_the_scene = scene.coupling.drag_law;
  if (is_varied_law(scene.coupling.drag_law)) {
    const drag::DragLawKernels law = find_drag_law(scene.coupling.drag_law);
    of_the_scene = law.info.name;
    for (league::Contender& contender : league::contenders_of(law)) contenders.push_back(std::move(contender));
  }
  found = league::recommend(scene, contenders, of_the_scene);
}

std::string evidence_text(const league::Evidence& evidence) {
  return fmt::format("{}, typically within {:.0f} % of the velocity, at most {:.0f} %", evidence.law->name(),
                     100.0 * evidence.statistic.root_mean_square, 100.0 * evidence.largest);
}

}  // namespace slfb
