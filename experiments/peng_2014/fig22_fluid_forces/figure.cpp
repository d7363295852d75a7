#include <fmt/format.h>

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
  FigureOutput output{"fig22", {}, "", run_notes(context, keys)};
  output.caption =
      "Mean drag (above) and mean pressure-gradient force (below) on the 6 mm steel sphere in the bed of 5 mm glass, "
      "over "
      "its weight, from entering the bed to the bottom. Open circles: the two ends of each curve, which "
      "are all that the paper prints. Filled symbols: our runs with 95 % intervals. Thin lines above: drag of "
      "the "
      "named law at the mean voidage of the bed (Eq. 36) and the paper's own velocities (Table 2). Thin lines below: "
      "the "
      "pressure gradient of the clear liquid, and that of the homogeneous bed, which carries its weight. The paper's "
      "force lies below both.";

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

  const std::string drag = plot_variants_against_bed("drag_ratio", "drag over weight [-]", system_name,
                                                     BedAbscissa::voidage, context, output);
  const std::string pressure =
      plot_variants_against_bed("pressure_gradient_ratio", "pressure-gradient force over weight [-]", system_name,
                                BedAbscissa::voidage, context, output);
  const std::string script =
      "set multiplot\nset lmargin at screen 0.14\nset rmargin at screen 0.97\nset xrange [0.42:0.86]\nset xtics 0.1\n"
      "middle = base + 0.5*(1 - base)\n"
      "set tmargin at screen 1 - 12.0/height\nset bmargin at screen middle + 22.0/height\nset format x ''\n"
      "set yrange [0:1.2]\nset ytics 0.2\nset ylabel 'drag over weight, |F_d|/mg [-]' offset 0.5,0\n"
      "set key top left Left reverse font ',11' spacing 1.05\n"
      "plot 'fig22_mean_field_drag.csv' skip 1 using 1:2 with lines linestyle 11 title 'Gidaspow at V_2 of Table 2', "
      "'' skip 1 using 1:3 with lines linestyle 12 title 'Wen and Yu at V_2 of Table 2', "
      "'fig22_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, printed'" +
      drag +
      "\neval footer_drawn\nset tmargin at screen middle - 2.0/height\nset bmargin at screen base + 60.0/height\n"
      "set format x '%g'\nset xlabel 'voidage α_L [-]'\nset yrange [0:0.3]\nset ytics 0.1\n"
      "set ylabel 'pressure gradient over weight [-]' offset 0.5,0\nset key bottom left Left reverse\n"
      "plot 'fig22_pressure_gradient.csv' skip 1 using 1:3 with lines linestyle 13 title 'homogeneous bed, "
      "ρ_M/ρ_{P2}', "
      "'' skip 1 using 1:2 with lines linestyle 14 title 'clear liquid, ρ_L/ρ_{P2}', "
      "'fig22_paper.csv' skip 1 using 1:3 with points linestyle 1 dashtype 1 notitle" +
      pressure + "\nunset multiplot\n";
  draw_figure_of_runs("fig22", script, {520, 720}, context, keys);
  return output;
}

}  // namespace

Figure fig22() {
  return {"fig22", "Drag and pressure-gradient force on the foreign particle", needs, draw,
          "peng_2014/fig22_fluid_forces"};
}

}  // namespace slfb
