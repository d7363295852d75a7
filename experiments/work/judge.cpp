#include "experiments/work/judge.hpp"

#include "experiments/runs/measure.hpp"
#include "experiments/work/more_runs.hpp"

namespace slfb {

Measurements measure_all(const Work& work, const std::vector<FinishedRun>& runs, const std::filesystem::path& out) {
  std::vector<FinishedRun> soft = runs;
  for (const ProfileVariant& same : work.unchanged) {
    Profile profile = load_profile(work, same.profile);
    std::erase_if(profile.runs, [&](const RunSpec& spec) { return spec.variant != same.variant; });
    for (FinishedRun& run : finished_runs(profile, out)) {
      if (run.stale) continue;
      run.spec.variant.clear();
      soft.push_back(std::move(run));
    }
  }
  Measurements measurements = measure_runs(soft, work.measuring);
  if (!work.shown_beside.empty()) {
    const std::vector<FinishedRun> stiff = runs_with_scene_stiffness(work, out);
    // What does not depend on the springs is the same in both: more beds, more drops.
    std::vector<FinishedRun> all = soft;
    all.insert(all.end(), stiff.begin(), stiff.end());
    for (auto& [key, measured] : measure_runs(all, work.measuring)) {
      const Quantity* quantity = find_quantity(work.measuring, key.quantity);
      if (quantity == nullptr || quantity->depends_on_contact_stiffness || quantity->of_packing) continue;
      measurements[key] = measured;
    }
    take_contacts_from(measure_runs(stiff, work.measuring), work.measuring, measurements);
  }
  if (work.without_runs) measurements.merge(work.without_runs());
  return measurements;
}

Judgement judge(const Work& work, const Profile& profile, const std::vector<Claim>& claims,
                const std::filesystem::path& out) {
  const MoreRuns more = load_more_runs(work, out);
  Judgement judgement{profile, with_more_runs(with_shown_runs(work, profile), more), {}, {}, {}};
  judgement.runs = finished_runs(judgement.shown, out);
  const Measurements own = measure_runs(own_runs(judgement.runs, profile.name), work.measuring);
  judgement.left_out = take_out_other_models(judgement.runs, work.measuring);
  judgement.measurements = measure_all(work, judgement.runs, out);
  judgement.evaluations = evaluate(claims, judgement.measurements, more.looks);
  if (work.name_causes) work.name_causes(judgement.evaluations, out);
  judge_run_gates(judgement.evaluations, own,
                  measure_runs(published_runs(with_more_runs(profile, more)), work.measuring));
  return judgement;
}

}  // namespace slfb
