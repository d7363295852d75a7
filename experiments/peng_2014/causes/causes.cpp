#include "experiments/peng_2014/causes/causes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace single_changes {
namespace {

constexpr std::array all_changes{
    Change{"paper-steps", "", "the paper's steps and stiffness"},
    Change{"causes", "coarse-grid", "cells of 7.1 mm"},
    Change{"causes", "fine-grid", "cells of 4.2 mm"},
    Change{"causes", "particle-meshing", "1214 pieces per sphere"},
    Change{"causes", "values-by-gradient", "values by gradient (Eqs. 30, 31)"},
    Change{"causes", "slip-wall", "slip at the wall"},
    Change{"causes", "disturbance-correction", "own disturbance corrected"},
    Change{"causes", "added-mass", "added mass"},
    Change{"causes", "lubrication", "lubrication"},
    Change{"causes", "restitution-0_5", "restitution 0.5"},
    Change{"causes", "no-rolling-friction", "no rolling friction"},
    Change{"drag-law", "gidaspow-1994_friction-0_1", "friction 0.1"},
    Change{"drag-law", "gidaspow-1994_friction-0", "friction 0"},
    Change{"drag-law", "wen-yu-1966_friction-0_3", "Wen and Yu's drag"},
    Change{"causes", "gibilaro-1985", "Gibilaro's drag"},
};

/// The runs of one variant under the keys of the unchanged scene.
std::vector<FinishedRun> runs_of(const Profile& profile, const std::string& variant,
                                 const std::filesystem::path& results) {
  std::vector<FinishedRun> runs = finished_runs(profile, results);
  std::erase_if(runs, [&](const FinishedRun& run) {
    return run.spec.system != system_name || run.spec.variant != variant || run.stale;
  });
  for (FinishedRun& run : runs) run.spec.variant.clear();
  return runs;
}

}  // namespace

std::span<const Change> changes() { return all_changes; }

Measurements measure(const Change& change, const std::filesystem::path& results) {
  return measure_runs(runs_of(load_profile(change.profile), change.variant, results), peng_2014_work().measuring);
}

Measurements measure_unchanged(const std::filesystem::path& results) {
  // The runs of profile lattice follow their drops for longer: at 0.06 m/s some do not come through in the 6 s of the
  // others, and those that do are the fast ones.
  auto runs = runs_of(load_profile("drag-law"), "gidaspow-1994_friction-0_3", results);
  for (FinishedRun& run : runs_of(load_profile("lattice"), "", results)) runs.push_back(std::move(run));
  return measure_runs(runs, peng_2014_work().measuring);
}

}  // namespace single_changes

namespace {

/// "quantity/6in5W/0.06" and the like, for the velocities that the changes were simulated at. The changes have softened
/// springs: what depends on their stiffness would show two changes.
bool is_of_this_bed(const Claim& claim) {
  return !claim.measures.empty() && std::all_of(claim.measures.begin(), claim.measures.end(), [](const auto& measure) {
    if (depends_on_contact_stiffness(peng_2014_work().measuring, measure.quantity)) return false;
    return std::any_of(single_changes::velocities.begin(), single_changes::velocities.end(), [&](double velocity) {
      return measure == measure_key(measure.quantity, single_changes::system_name, velocity);
    });
  });
}

}  // namespace

void name_causes(std::vector<Evaluation>& evaluations, const std::filesystem::path& results) {
  std::vector<Claim> claims;
  for (const Evaluation& evaluation : evaluations)
    if (evaluation.verdict == Verdict::not_reproduced && is_of_this_bed(evaluation.claim))
      claims.push_back(evaluation.claim);
  if (claims.empty()) return;
  std::vector<std::string> found(claims.size());
  for (const single_changes::Change& change : single_changes::changes()) {
    const auto changed = evaluate(claims, single_changes::measure(change, results));
    for (std::size_t k = 0; k < claims.size(); ++k)
      if (changed[k].verdict == Verdict::reproduced)
        found[k] += fmt::format("{}{}", found[k].empty() ? "" : ", ", change.title);
  }
  for (Evaluation& evaluation : evaluations)
    for (std::size_t k = 0; k < claims.size(); ++k)
      if (evaluation.claim.id == claims[k].id)
        evaluation.reason += found[k].empty() ? "; no single change of figure causes brings it inside"
                                              : fmt::format("; inside with one change (figure causes): {}", found[k]);
}

}  // namespace slfb
