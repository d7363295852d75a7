#include "experiments/peng_2014/causes/causes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace single_changes {
namespace {

constexpr std::array all_changes{
    Change{Base::default_scene, "screening", "kt-0.01_by-gradient_own-spread_springs-1e4",
           "own volume spread where alone"},
    Change{Base::default_scene, "screening", "kt-0.003_by-gradient_springs-1e4", "k_t/k_n 0.003, not 0.01"},
    Change{Base::default_scene, "screening", "kt-0.05_by-gradient_springs-1e4", "k_t/k_n 0.05"},
    Change{Base::default_scene, "screening", "by-gradient_springs-1e4", "k_t/k_n 2/7"},
    Change{Base::default_scene, "candidates", "random-wet_kt-0.01_by-gradient_springs-1e4", "settled in the liquid"},
    Change{Base::default_scene, "screening", "kt-0.01_springs-1e4", "values by shares, not by gradient"},
    Change{Base::default_scene, "candidates", "kt-0.01_cells-8.3_by-gradient_springs-1e4", "cells of 8.3 mm, not 7.1"},
    Change{Base::default_scene, "candidates", "kt-0.01_by-gradient_wen-yu_springs-1e4", "Wen and Yu's drag"},
    Change{Base::lattice, "paper-steps", "", "the paper's steps and stiffness"},
    Change{Base::lattice, "causes", "coarse-grid", "cells of 7.1 mm, not 6.3"},
    Change{Base::lattice, "causes", "fine-grid", "cells of 4.2 mm"},
    Change{Base::lattice, "causes", "particle-meshing", "1214 pieces per sphere"},
    Change{Base::lattice, "causes", "values-by-gradient", "values by gradient (Eqs. 30, 31)"},
    Change{Base::lattice, "causes", "slip-wall", "slip at the wall"},
    Change{Base::lattice, "causes", "disturbance-correction", "own disturbance corrected"},
    Change{Base::lattice, "causes", "added-mass", "added mass"},
    Change{Base::lattice, "causes", "lubrication", "lubrication"},
    Change{Base::lattice, "causes", "restitution-0_5", "restitution 0.5"},
    Change{Base::lattice, "causes", "no-rolling-friction", "no rolling friction"},
    Change{Base::lattice, "drag-law", "gidaspow-1994_friction-0_1", "friction 0.1"},
    Change{Base::lattice, "drag-law", "gidaspow-1994_friction-0", "friction 0"},
    Change{Base::lattice, "drag-law", "wen-yu-1966_friction-0_3", "Wen and Yu's drag"},
    Change{Base::lattice, "causes", "gibilaro-1985", "Gibilaro's drag"},
};

}  // namespace

std::span<const Change> changes() { return all_changes; }

std::vector<FinishedRun> runs_of(const Profile& profile, const std::string& variant,
                                 const std::filesystem::path& results) {
  std::vector<FinishedRun> runs = finished_runs(profile, results);
  std::erase_if(runs, [&](const FinishedRun& run) {
    return run.spec.system != system_name || run.spec.variant != variant || run.stale;
  });
  for (FinishedRun& run : runs) run.spec.variant.clear();
  return runs;
}

Measurements measure(const Change& change, const std::filesystem::path& results) {
  return measure_runs(runs_of(load_profile(change.profile), change.variant, results), peng_2014_work().measuring);
}

Measurements measure_unchanged(Base base, const std::filesystem::path& results) {
  if (base == Base::default_scene)
    return measure_runs(runs_of(load_profile("screening"), "kt-0.01_by-gradient_springs-1e4", results),
                        peng_2014_work().measuring);
  // The runs of profile lattice follow their drops for longer: at 0.06 m/s some do not come through in the 6 s of the
  // others, and those that do are the fast ones.
  auto runs = runs_of(load_profile("drag-law"), "gidaspow-1994_friction-0_3", results);
  for (FinishedRun& run : runs_of(load_profile("lattice"), "", results)) runs.push_back(std::move(run));
  return measure_runs(runs, peng_2014_work().measuring);
}

}  // namespace single_changes

namespace {

/// "quantity/6in5W/0.06" and the like, for the velocities that the changes were simulated at.
bool is_of_this_bed(const Claim& claim) {
  return !claim.measures.empty() && std::all_of(claim.measures.begin(), claim.measures.end(), [](const auto& measure) {
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
    if (change.base != single_changes::Base::default_scene) continue;
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
