#include <fmt/format.h>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig24", {}, "", run_notes(context, keys)};
  output.caption =
      "Mean collision force on the 6 mm steel sphere in the bed of 5 mm glass over its weight, against the voidage of "
      "the "
      "bed. Dashed black: the paper's correlation (Eq. 40); shaded: 10 and 20 % about it, in which the paper finds "
      "most "
      "and all of its points. Filled symbols: mean of the magnitude of the contact force, from entering the bed to the "
      "bottom, with 95 % intervals. Open diamonds: magnitude of the mean force over the same time, the other reading "
      "of "
      "the symbol. The paper's points are not available as numbers.";

  const double most = peng_2014().value("equation_40_most");
  const double all = peng_2014().value("equation_40_all");
  DataTable correlation{
      "fig24_equation_40", {"voidage [-]", "Eq. 40 [-]", "-10 % [-]", "+10 % [-]", "-20 % [-]", "+20 % [-]"}, {}};
  for (int step = 425; step <= 1000; step += 5) {
    const double voidage = 1e-3 * step;
    const double force = collision::Peng2014{}(paper::steel_in_glass(0.0, voidage), 0.0);
    correlation.rows.push_back(
        {voidage, force, (1.0 - most) * force, (1.0 + most) * force, (1.0 - all) * force, (1.0 + all) * force});
  }
  output.data.push_back(write_csv(correlation, context.out));

  const std::string magnitude =
      plot_variants_against_bed("collision_force_ratio", "mean of the magnitude over weight [-]", system_name,
                                BedAbscissa::voidage, context, output);
  DataTable table = against_bed(context, "collision_force_ratio_of_mean", "magnitude of the mean over weight [-]",
                                system_name, "", BedAbscissa::voidage);
  std::string of_mean;
  if (!table.rows.empty()) {
    table.name = "fig24_" + table.name;
    output.data.push_back(write_csv(table, context.out));
    of_mean = fmt::format(
        ", {}'{}.csv' skip 1 using 2:4 with points linestyle 2 pointtype 12 pointsize 0.9 title "
        "'magnitude of the mean force'",
        error_bars(table, {2, 4, 5}, "yerrorbars", 2), table.name);
  }
  const std::string script =
      "set key tmargin left vertical maxrows 6 Left reverse font ',12'\nset xrange [0.4:1]\nset yrange [0:1.25]\n"
      "set ytics 0.25\nset xlabel 'voidage α_L [-]'\nset ylabel 'collision force over weight, |F_c|/mg [-]'\n"
      "set style fill transparent solid 0.09 noborder\n"
      "plot 'fig24_equation_40.csv' skip 1 using 1:5:6 with filledcurves linecolor rgb paper notitle, "
      "'' skip 1 using 1:3:4 with filledcurves linecolor rgb paper notitle, "
      "'' skip 1 using 1:2 with lines linestyle 1 title 'paper, Eq. 40, with 10 and 20 %'" +
      magnitude + of_mean + "\n";
  draw_figure_of_runs("fig24", script, {520, 480}, context, keys);
  return output;
}

}  // namespace

Figure fig24() {
  return {"fig24", "Collision force against the voidage, and Eq. 40", needs, draw, "peng_2014/fig24_force_and_voidage"};
}

}  // namespace slfb
