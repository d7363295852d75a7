#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/causes/causes.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

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

struct Quantity {
  const char *name, *title;
};
constexpr std::array quantities{
    Quantity{"packed_voidage", "packed bed"},   Quantity{"voidage_centre_of_mass", "voidage"},
    Quantity{"classification_velocity", "V_2"}, Quantity{"collision_force_ratio", "|F_c|/mg"},
    Quantity{"drag_ratio", "drag/mg"},          Quantity{"collision_frequency", "f_{coll}"},
    Quantity{"mean_contacts", "contacts"},      Quantity{"fluctuating_energy", "q_p^2"}};

/// Measurements of one variant under the keys of the unchanged scene.
Measurements measured(const Profile& profile, const std::string& variant, const std::filesystem::path& results) {
  std::vector<FinishedRun> runs = finished_runs(profile, results);
  std::erase_if(runs, [&](const FinishedRun& run) {
    return run.spec.system != system_name || run.spec.variant != variant || run.stale;
  });
  for (FinishedRun& run : runs) run.spec.variant.clear();
  return measure_runs(runs);
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
  const Measurements own = measure_runs(runs), base = base_measurements(outer.results);
  const FigureContext context{profile, runs, own, outer.out, outer.results};
  const auto keys = needs(profile);
  FigureOutput output{"causes", {}, "", run_notes(context, keys)};

  DataTable table{"causes", {"row [-]"}, {}};
  for (const double velocity : velocities)
    for (const Quantity& quantity : quantities)
      for (const char* what : {"ratio", "half width"})
        table.columns.push_back(fmt::format("{} {} at {:.2f} m/s [-]", quantity.name, what, velocity));
  std::string names, nameless;  // tics of the first panel and of the others
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const Measurements changed = measured(load_profile(changes[k].profile), changes[k].variant, outer.results);
    std::vector<double> row{static_cast<double>(k)};
    for (const double velocity : velocities)
      for (const Quantity& quantity : quantities) {
        const Ratio ratio = ratio_of(changed, base, measure_key(quantity.name, system_name, velocity));
        row.insert(row.end(), {ratio.value, ratio.half_width});
      }
    table.rows.push_back(std::move(row));
    names += fmt::format("{}\"{}\" {}", k > 0 ? ", " : "", changes[k].title, k);
    nameless += fmt::format("{}\"\" {}", k > 0 ? ", " : "", k);
  }
  output.data.push_back(write_csv(table, outer.out));
  output.caption =
      "Each row changes one thing of the bed of 5 mm glass under the falling 6 mm steel sphere and leaves the rest as "
      "in "
      "profile drag-law with Gidaspow's law and friction 0.3. Shown is the quantity over that of the unchanged bed, at "
      "U_L = 0.06 m/s (circles) and 0.10 m/s (squares), with 95 % intervals (packed bed: voidage as settled, one bed, "
      "which "
      "U_L does not change). Points beyond the axes are drawn at their "
      "ends. The row of the paper's own steps has its springs and duration too. The claims say in their reasons which "
      "of these changes would bring them inside the paper's band.";

  std::string script = fmt::format(
      "set multiplot\nset tmargin at screen 1 - 34.0/height\nset bmargin at screen base + 40.0/height\n"
      "set yrange [{}:-0.7]\nset xrange [0:2.4]\nset xtics 1\nset mxtics 2\nset grid x y\nset key at screen 0.01, "
      "screen 1 - 6.0/height left top Left reverse font ',11'\n"
      "set ytics ({})\nset arrow 1 from 1,graph 0 to 1,graph 1 nohead linecolor rgb paper\nunset xlabel\nunset ylabel\n"
      "inside(x) = x > 2.4 ? 2.4 : x\n",
      static_cast<double>(changes.size()) - 0.3, names);
  constexpr double left = 0.2, right = 0.99;
  const double width = (right - left) / static_cast<double>(quantities.size());
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const double start = left + width * static_cast<double>(q);
    script += fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset title '{}' font ',12'\n",
                          start, start + width - 0.012, quantities[q].title);
    std::string plots;
    for (std::size_t v = 0; v < velocities.size(); ++v) {
      const std::size_t column = 2 + 2 * (v * quantities.size() + q);
      const auto any = [&](std::size_t number) {
        return std::ranges::any_of(table.rows, [&](const auto& row) { return std::isfinite(row[number - 1]); });
      };
      const std::string style =
          fmt::format("linecolor rgb {} pointtype {}", v == 0 ? "ours" : "variant", v == 0 ? 7 : 5);
      const double shift = v == 0 ? -0.15 : 0.15;
      if (any(column + 1))
        plots += fmt::format(", 'causes.csv' skip 1 using {}:($1+{}):{} with xerrorbars {} pointsize 0.01 notitle",
                             column, shift, column + 1, style);
      // What is not simulated yet keeps its place in the key.
      plots += any(column)
                   ? fmt::format(", 'causes.csv' skip 1 using (inside(${})):($1+{}) with points {} pointsize 0.7",
                                 column, shift, style)
                   : fmt::format(", NaN with points {} pointsize 0.7", style);
      plots += fmt::format(" title '{:.2f} m/s'", velocities[v]);
    }
    plots.replace(0, 2, "plot ");
    script += plots + "\n";
    if (q == 0) script += fmt::format("eval footer_drawn\nunset key\nset ytics ({})\n", nameless);
  }
  script += "unset multiplot\n";
  draw_figure_of_runs("causes", script, {1300, 560}, context, keys);
  return output;
}

/// "quantity/6in5W/0.06" and the like, for the velocities that the changes were simulated at. The changes have softened
/// springs, so that what hangs on these would show two changes.
bool is_of_this_bed(const Claim& claim) {
  return !claim.measures.empty() && std::all_of(claim.measures.begin(), claim.measures.end(), [](const auto& measure) {
    if (depends_on_contact_stiffness(measure.quantity)) return false;
    return std::any_of(velocities.begin(), velocities.end(), [&](double velocity) {
      return measure == measure_key(measure.quantity, system_name, velocity);
    });
  });
}

}  // namespace

Figure causes() { return {"causes", "What one change does", needs, draw, "peng_2014/causes"}; }

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
