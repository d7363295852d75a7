#include <fmt/format.h>

#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"

namespace slfb::fig16_contacts {
namespace {

const FigureFolder folder{"peng_2014/fig16_contacts"};

/// The system of the paper, and the one of most other figures beside it.
bool wanted(const RunSpec& spec) {
  return spec.variant.empty() && spec.superficial_velocity > 0.03 &&
         (spec.system == "6in3W" || (spec.system == "6in5W" && spec.superficial_velocity > 0.055));
}

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig16", {}, folder.caption(), run_notes(context, keys)};
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  output.data.push_back(
      write_csv({"fig16_paper",
                 {"voidage [-]", "mean contacts [-]", "most contacts [-]"},
                 {{0.45, printed.value("mean_contacts_dense"), printed.value("maximum_contacts_dense")},
                  {0.65, std::nan(""), printed.value("maximum_contacts_dilute")},
                  {0.79, printed.value("mean_contacts_dilute"), printed.value("maximum_contacts_dilute")}}},
                context.out));
  std::vector<Series> mean, most;
  for (const BedSystem& system : {bed_systems[0], bed_systems[2]}) {
    const auto contacts = [&](std::string_view quantity) {
      DataTable table = against_bed(context, quantity, "contacts [-]", system.name, "", BedAbscissa::voidage);
      table.name = "fig16_" + table.name;
      return table;
    };
    mean.push_back({contacts("mean_contacts"), std::string(system.title), system.line_style});
    most.push_back({contacts("maximum_contacts"), "", system.line_style});
  }
  PlotValues values;
  add_series("mean", mean, values, context, output);
  add_series("most", most, values, context, output);
  draw_plot_of_runs("fig16", folder.plot(), values, {520, 620}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig16", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig16_contacts
