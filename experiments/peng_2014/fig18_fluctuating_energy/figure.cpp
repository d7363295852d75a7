#include <fmt/format.h>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::fig18_fluctuating_energy {
namespace {

const FigureFolder folder{"peng_2014/fig18_fluctuating_energy"};
constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig18", {}, folder.caption(), run_notes(context, keys)};
  const DataTable axis{
      "fig18_paper_axis",
      {"solid fraction [-]", "lowest [m2/s2]", "highest [m2/s2]"},
      {{0.2, peng_2014().value("fluctuating_energy_lowest"), peng_2014().value("fluctuating_energy_highest")},
       {0.6, peng_2014().value("fluctuating_energy_lowest"), peng_2014().value("fluctuating_energy_highest")}}};
  output.data.push_back(write_csv(axis, context.out));

  PlotValues values;
  add_series("whole_bed",
             variants_against_bed("fig18", "fluctuating_energy", "fluctuating energy [m2/s2]", system_name,
                                  BedAbscissa::solid_fraction, context),
             values, context, output);
  DataTable boxes = against_bed(context, "local_fluctuating_energy", "fluctuating energy about boxes [m2/s2]",
                                system_name, "", BedAbscissa::solid_fraction);
  boxes.name = "fig18_" + boxes.name;
  add_series("boxes", {{std::move(boxes), "the same about boxes of 4 diameters", 2}}, values, context, output);
  draw_plot_of_runs("fig18", folder.plot(), values, {520, 470}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig18", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig18_fluctuating_energy
