#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/causes/causes.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

const FigureFolder folder{"peng_2014/causes"};
constexpr const char* system_name = "6in5W";
constexpr std::array velocities{0.06, 0.10};  // [m/s]
constexpr const char* unchanged = "gidaspow-1994_friction-0_3";

struct Change {
  const char *profile, *variant, *title;
};
/// From the top of the figure down: numerics, liquid, forces, contacts, drag law.
constexpr std::array changes{
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

struct ShownQuantity {
  const char *name, *title;
};
constexpr std::array quantities{
    ShownQuantity{"packed_voidage", "packed bed"},   ShownQuantity{"voidage_centre_of_mass", "voidage"},
    ShownQuantity{"classification_velocity", "V_2"}, ShownQuantity{"collision_force_ratio", "|F_c|/mg"},
    ShownQuantity{"drag_ratio", "drag/mg"},          ShownQuantity{"collision_frequency", "f_{coll}"},
    ShownQuantity{"mean_contacts", "contacts"},      ShownQuantity{"fluctuating_energy", "q_p^2"}};

/// Measurements of one variant under the keys of the unchanged scene.
Measurements measured(const Profile& profile, const std::string& variant, const std::filesystem::path& results) {
  std::vector<FinishedRun> runs = finished_runs(profile, results);
  std::erase_if(runs, [&](const FinishedRun& run) {
    return run.spec.system != system_name || run.spec.variant != variant || run.stale;
  });
  for (FinishedRun& run : runs) run.spec.variant.clear();
  return measure_runs(runs, peng_2014_work().measuring);
}

Measurements base_measurements(const std::filesystem::path& results) {
  return measured(load_profile("drag-law"), unchanged, results);
}

std::vector<std::string> needs(const Profile& profile) {
  if (profile.name != "causes") return {};
  return select_run_keys(profile, [](const RunSpec&) { return true; });
}

/// Ratio of two measurements with the interval that their independent intervals give.
struct Ratio {
  double value = std::nan(""), half_width = std::nan("");
};
Ratio ratio_of(const Measurements& ours, const Measurements& base, const MeasureKey& key) {
  const auto a = ours.find(key), b = base.find(key);
  if (a == ours.end() || b == base.end() || !(std::fabs(b->second.value) > 0.0)) return {};
  const double ratio = a->second.value / b->second.value;
  return {ratio, std::fabs(ratio) *
                     std::hypot(a->second.half_width / a->second.value, b->second.half_width / b->second.value)};
}

FigureOutput draw(const FigureContext& outer) {
  const Profile profile = load_profile("causes");
  const auto runs = finished_runs(profile, outer.results);
  const Measurements own = measure_runs(runs, peng_2014_work().measuring), base = base_measurements(outer.results);
  const FigureContext context{profile, runs, own, outer.out, outer.results};
  const auto keys = needs(profile);
  FigureOutput output{"causes", {}, folder.caption(), run_notes(context, keys)};

  DataTable table{"causes", {"row [-]"}, {}};
  for (const double velocity : velocities)
    for (const ShownQuantity& quantity : quantities)
      for (const char* what : {"ratio", "half width"})
        table.columns.push_back(fmt::format("{} {} at {:.2f} m/s [-]", quantity.name, what, velocity));
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const Measurements changed = measured(load_profile(changes[k].profile), changes[k].variant, outer.results);
    std::vector<double> row{static_cast<double>(k)};
    for (const double velocity : velocities)
      for (const ShownQuantity& quantity : quantities) {
        const Ratio ratio = ratio_of(changed, base, measure_key(quantity.name, system_name, velocity));
        row.insert(row.end(), {ratio.value, ratio.half_width});
      }
    table.rows.push_back(std::move(row));
  }
  output.data.push_back(write_csv(table, outer.out));

  PlotValues values;
  std::vector<std::string> change_titles, quantity_titles;
  for (const Change& change : changes) change_titles.emplace_back(change.title);
  for (const ShownQuantity& quantity : quantities) quantity_titles.emplace_back(quantity.title);
  values.texts("change", change_titles);
  values.markups("quantity", quantity_titles);
  values.numbers("velocity", {velocities.begin(), velocities.end()});
  draw_plot_of_runs("causes", folder.plot(), values, {1300, 560}, context, keys);
  return output;
}

/// "quantity/6in5W/0.06" and the like, for the velocities that the changes were simulated at. The changes have softened
/// springs, so that what hangs on these would show two changes.
bool is_of_this_bed(const Claim& claim) {
  return !claim.measures.empty() && std::all_of(claim.measures.begin(), claim.measures.end(), [](const auto& measure) {
    if (depends_on_contact_stiffness(peng_2014_work().measuring, measure.quantity)) return false;
    return std::any_of(velocities.begin(), velocities.end(), [&](double velocity) {
      return measure == measure_key(measure.quantity, system_name, velocity);
    });
  });
}

}  // namespace

Figure causes() { return {"causes", folder.title(), needs, draw, folder.path().string()}; }

void name_causes(std::vector<Evaluation>& evaluations, const std::filesystem::path& results) {
  std::vector<Claim> claims;
  for (const Evaluation& evaluation : evaluations)
    if (evaluation.verdict == Verdict::not_reproduced && is_of_this_bed(evaluation.claim))
      claims.push_back(evaluation.claim);
  if (claims.empty()) return;
  std::vector<std::string> found(claims.size());
  for (const Change& change : changes) {
    const auto changed = evaluate(claims, measured(load_profile(change.profile), change.variant, results));
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
