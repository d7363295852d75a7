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

namespace slfb::causes {
namespace {

const FigureFolder folder{"peng_2014/causes"};

using single_changes::Base, single_changes::Change, single_changes::changes, single_changes::system_name,
    single_changes::velocities;

struct ShownQuantity {
  const char *name, *title;
};
constexpr std::array quantities{
    ShownQuantity{"packed_voidage", "packed bed"},   ShownQuantity{"voidage_centre_of_mass", "voidage"},
    ShownQuantity{"classification_velocity", "V_2"}, ShownQuantity{"collision_force_ratio", "|F_c|/mg"},
    ShownQuantity{"drag_ratio", "drag/mg"},          ShownQuantity{"collision_frequency", "f_{coll}"},
    ShownQuantity{"mean_contacts", "contacts"},      ShownQuantity{"fluctuating_energy", "q_p^2"}};

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
  // A median of drops of which some had not come through has no half-width, but its value is an end of what is
  // possible.
  return {ratio, std::fabs(ratio) *
                     std::hypot(a->second.half_width / a->second.value, b->second.half_width / b->second.value)};
}

/// Highest end of any interval of a quantity, for the end of its axis.
double highest_of(const DataTable& table, std::size_t quantity) {
  double highest = 2.0;
  for (const std::vector<double>& row : table.rows)
    for (std::size_t v = 0; v < velocities.size(); ++v) {
      const std::size_t column = 1 + 2 * (v * quantities.size() + quantity);
      const double half_width = std::isfinite(row[column + 1]) ? row[column + 1] : 0.0;
      if (std::isfinite(row[column])) highest = std::max(highest, row[column] + half_width);
    }
  return 1.05 * highest;
}

FigureOutput draw(const FigureContext& outer) {
  const Profile profile = load_profile("causes");
  const auto runs = finished_runs(profile, outer.results);
  const Measurements own = measure_runs(runs, peng_2014_work().measuring),
                     of_default = single_changes::measure_unchanged(Base::default_scene, outer.results),
                     of_lattice = single_changes::measure_unchanged(Base::lattice, outer.results);
  const FigureContext context{profile, runs, own, outer.out, outer.results};
  const auto keys = needs(profile);
  FigureOutput output{"causes", {}, folder.caption(), run_notes(context, keys)};

  DataTable table{"causes", {"row [-]"}, {}};
  for (const double velocity : velocities)
    for (const ShownQuantity& quantity : quantities)
      for (const char* what : {"ratio", "half width"})
        table.columns.push_back(fmt::format("{} {} at {:.2f} m/s [-]", quantity.name, what, velocity));
  for (const Change& change : changes()) {
    const Measurements changed = single_changes::measure(change, outer.results);
    const Measurements& base = change.base == Base::lattice ? of_lattice : of_default;
    std::vector<double> row{static_cast<double>(table.rows.size())};
    for (const double velocity : velocities)
      for (const ShownQuantity& quantity : quantities) {
        const Ratio ratio = ratio_of(changed, base, measure_key(quantity.name, system_name, velocity));
        row.insert(row.end(), {ratio.value, ratio.half_width});
      }
    table.rows.push_back(std::move(row));
  }
  output.data.push_back(write_csv(table, outer.out));

  std::vector<double> ends;
  for (std::size_t q = 0; q < quantities.size(); ++q) ends.push_back(highest_of(table, q));

  PlotValues values;
  values.numbers("end", ends);
  std::vector<std::string> change_titles, quantity_titles;
  for (const Change& change : changes()) change_titles.emplace_back(change.title);
  for (const ShownQuantity& quantity : quantities) quantity_titles.emplace_back(quantity.title);
  values.number("first_of_lattice",
                static_cast<double>(std::ranges::find(changes(), Base::lattice, &Change::base) - changes().begin()));
  values.texts("change", change_titles);
  values.markups("quantity", quantity_titles);
  values.numbers("velocity", {velocities.begin(), velocities.end()});
  draw_plot_of_runs("causes", folder.plot(), values, {1300, 720}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"causes", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::causes
