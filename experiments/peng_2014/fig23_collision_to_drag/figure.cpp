#include <fmt/format.h>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig23", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Mean collision force over mean drag on the 6 mm steel sphere in the bed of 5 mm glass. Dashed black: the "
      "largest "
      "ratio that the paper states, {:g}. Crosses: Eq. 40 over the drag that the paper prints for both ends of "
      "its "
      "range. Thin lines: Eq. 40 over the drag of the named law at the mean voidage (Eq. 36) and the velocities of "
      "Table "
      "2. Filled symbols: our runs with 95 % intervals. Above the dotted line the collisions dominate. The paper's "
      "points "
      "are not available as numbers.",
      printed.value("collision_drag_ratio"));

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

  const std::string simulated = plot_variants_against_bed("collision_to_drag_ratio", "collision force over drag [-]",
                                                          system_name, BedAbscissa::voidage, context, output);
  const std::string script = fmt::format(
      "set key tmargin left vertical maxrows 7 Left reverse font ',12'\nset xrange [0.42:0.86]\nset yrange [0:12]\n"
      "set ytics 2\nset xlabel 'voidage α_L [-]'\nset ylabel 'collision force over drag, |F_c|/|F_d| [-]'\n"
      "plot {:g} with lines linestyle 1 title 'paper, largest ratio', 1 with lines linestyle 20 notitle, "
      "'fig23_laws.csv' skip 1 using 1:2 with lines linestyle 11 title 'Eq. 40 over Gidaspow at V_2 of Table 2', "
      "'' skip 1 using 1:3 with lines linestyle 12 title 'Eq. 40 over Wen and Yu at V_2 of Table 2', "
      "'fig23_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 pointtype 1 title 'Eq. 40 over the "
      "printed drag'{}\n",
      printed.value("collision_drag_ratio"), simulated);
  draw_figure_of_runs("fig23", script, {520, 500}, context, keys);
  return output;
}

}  // namespace

Figure fig23() { return {"fig23", "Collision force over drag", needs, draw, "peng_2014/fig23_collision_to_drag"}; }

}  // namespace slfb
