#include <fmt/format.h>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig23_collision_to_drag {
namespace {

const FigureFolder folder{"peng_2014/fig23_collision_to_drag"};
constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  const double largest = printed.value("collision_drag_ratio");
  FigureOutput output{
      "fig23", {}, folder.caption({{"largest", fmt::format("{:g}", largest)}}), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::force_ratio, grid_convergence::voidage}, context, output);

  const auto equation_40 = [](double voidage) {
    return collision::Peng2014{}(paper::steel_in_glass(0.0, voidage), 0.0);
  };
  const double begin = printed.value("voidage_range_begin"), end = printed.value("voidage_range_end");
  output.data.push_back(write_csv({"fig23_paper",
                                   {"voidage [-]", "Eq. 40 over the printed drag [-]"},
                                   {{begin, equation_40(begin) / printed.value("drag_ratio_dense")},
                                    {end, equation_40(end) / printed.value("drag_ratio_dilute")}}},
                                  context.out));
  DataTable laws{
      "fig23_laws", {"voidage [-]", "Eq. 40 over Gidaspow's drag [-]", "Eq. 40 over Wen and Yu's drag [-]"}, {}};
  for (const auto& row : printed.table2()) {
    const double voidage = paper::steel_in_glass(row.superficial_velocity).voidage;
    const auto drag = [&](const char* name) {
      return context.measurements.at(measure_key("drag_ratio", name, row.superficial_velocity)).value;
    };
    laws.rows.push_back(
        {voidage, equation_40(voidage) / drag("gidaspow-1994"), equation_40(voidage) / drag("wen-yu-1966")});
  }
  output.data.push_back(write_csv(laws, context.out));

  PlotValues values;
  values.number("largest", largest);
  add_series("simulated",
             variants_against_bed("fig23", "collision_to_drag_ratio", "collision force over drag [-]", system_name,
                                  BedAbscissa::voidage, context),
             values, context, output);
  draw_plot_of_runs("fig23", folder.plot(), values, {520, 500}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig23", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig23_collision_to_drag
