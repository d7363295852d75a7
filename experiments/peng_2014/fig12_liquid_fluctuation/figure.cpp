#include <fmt/format.h>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::fig12_liquid_fluctuation {
namespace {

const FigureFolder folder{"peng_2014/fig12_liquid_fluctuation"};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.variant.empty() && (spec.system == "6in3N" || spec.system == "6in5N" ||
                                    (spec.system == "6in5W" && spec.superficial_velocity > 0.055));
  });
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig12",
                      {},
                      folder.caption({{"rise_begin", fmt::format("{}", printed.value("fluctuation_rise_begin"))},
                                      {"rise_end", fmt::format("{}", printed.value("fluctuation_rise_end"))}}),
                      run_notes(context, keys)};
  output.data.push_back(write_csv(
      {"fig12_paper_axis",
       {"voidage [-]", "lowest [m/s]", "highest [m/s]"},
       {{printed.value("fluctuation_rise_begin"), 0.0, 1.0}, {printed.value("fluctuation_rise_end"), 0.0, 1.0}}},
      context.out));
  std::vector<Series> vector, vertical;
  for (const BedSystem& system : {bed_systems[6], bed_systems[7], bed_systems[2]}) {
    const auto against_voidage = [&](const char* quantity, const char* heading) {
      DataTable table = against_bed(context, quantity, heading, system.name, "", BedAbscissa::voidage);
      table.name = "fig12_" + table.name;
      return table;
    };
    vector.push_back(
        {against_voidage("liquid_fluctuation", "mean |u - mean u| [m/s]"),
         fmt::format("{:g} mm, {}", 1e3 * system.bed_diameter, system.name.ends_with('N') ? "NaI" : "water"),
         system.line_style});
    vertical.push_back(
        {against_voidage("liquid_fluctuation_vertical", "mean |u_z - mean u_z| [m/s]"), "", system.line_style});
  }
  PlotValues values;
  add_series("vector", vector, values, context, output);
  add_series("vertical", vertical, values, context, output);
  draw_plot_of_runs("fig12", folder.plot(), values, {520, 720}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig12", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig12_liquid_fluctuation
