#include <fmt/format.h>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig22_fluid_forces {
namespace {

const FigureFolder folder{"peng_2014/fig22_fluid_forces"};
constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig22", {}, folder.caption(), run_notes(context, keys)};
  const double begin = printed.value("voidage_range_begin"), end = printed.value("voidage_range_end");
  output.data.push_back(write_csv({"fig22_paper",
                                   {"voidage [-]", "drag over weight [-]", "pressure-gradient force over weight [-]"},
                                   {{begin, printed.value("drag_ratio_dense"), printed.value("pressure_ratio_dense")},
                                    {end, printed.value("drag_ratio_dilute"), printed.value("pressure_ratio_dilute")}}},
                                  context.out));

  DataTable laws{"fig22_mean_field_drag", {"voidage [-]", "Gidaspow 1994 [-]", "Wen and Yu 1966 [-]"}, {}};
  for (const auto& row : printed.table2()) {
    const auto law = [&](const char* name) {
      return context.measurements.at(measure_key("drag_ratio", name, row.superficial_velocity)).value;
    };
    laws.rows.push_back(
        {paper::steel_in_glass(row.superficial_velocity).voidage, law("gidaspow-1994"), law("wen-yu-1966")});
  }
  output.data.push_back(write_csv(laws, context.out));
  DataTable gradients{"fig22_pressure_gradient", {"voidage [-]", "clear liquid [-]", "homogeneous bed [-]"}, {}};
  for (const double voidage : {0.4, 0.6, 0.8, 0.9})
    gradients.rows.push_back(
        {voidage, paper::water().density / paper::steel(0.006).density,
         suspension_density(voidage, paper::glass(0.005), paper::water()) / paper::steel(0.006).density});
  output.data.push_back(write_csv(gradients, context.out));

  PlotValues values;
  add_series(
      "drag",
      variants_against_bed("fig22", "drag_ratio", "drag over weight [-]", system_name, BedAbscissa::voidage, context),
      values, context, output);
  add_series("pressure",
             variants_against_bed("fig22", "pressure_gradient_ratio", "pressure-gradient force over weight [-]",
                                  system_name, BedAbscissa::voidage, context),
             values, context, output);
  draw_plot_of_runs("fig22", folder.plot(), values, {520, 720}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig22", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig22_fluid_forces
