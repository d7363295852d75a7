#include <fmt/format.h>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig18", {}, "", run_notes(context, keys)};
  output.caption =
      "Fluctuating kinetic energy of the fluidised spheres (5 mm glass in water), 3/2 of the velocity variance per "
      "component (Eq. 39), against the solid fraction of the bed. Filled symbols: our runs with 95 % intervals, the "
      "velocity taken about the mean of the whole bed. Open triangles: the same about the mean of boxes of four "
      "diameters, which leaves out large circulations. Shaded: the range of the paper's axis, which holds all its "
      "points; the points themselves are not available as numbers.";

  const DataTable axis{
      "fig18_paper_axis",
      {"solid fraction [-]", "lowest [m2/s2]", "highest [m2/s2]"},
      {{0.2, peng_2014().value("fluctuating_energy_lowest"), peng_2014().value("fluctuating_energy_highest")},
       {0.6, peng_2014().value("fluctuating_energy_lowest"), peng_2014().value("fluctuating_energy_highest")}}};
  output.data.push_back(write_csv(axis, context.out));

  const std::string bed = plot_variants_against_bed("fluctuating_energy", "fluctuating energy [m2/s2]", system_name,
                                                    BedAbscissa::solid_fraction, context, output);
  DataTable table = against_bed(context, "local_fluctuating_energy", "fluctuating energy about boxes [m2/s2]",
                                system_name, "", BedAbscissa::solid_fraction);
  std::string local;
  if (!table.rows.empty()) {
    table.name = "fig18_" + table.name;
    output.data.push_back(write_csv(table, context.out));
    local = fmt::format(
        ", {}{}'{}.csv' skip 1 using 2:4 with points linestyle 2 pointtype 8 pointsize 0.8 title 'the same about boxes "
        "of "
        "4 diameters'",
        error_bars(table, {2, 4, 5}, "yerrorbars", 2), error_bars(table, {2, 4, 3}, "xerrorbars", 2), table.name);
  }
  const std::string script =
      "set key tmargin left vertical maxrows 6 Left reverse font ',12'\nset xrange [0.2:0.6]\nset logscale y\n"
      "set yrange [1e-4:3e-2]\nset format y '10^{%L}'\nset xlabel 'solid fraction α_S [-]'\n"
      "set ylabel 'fluctuating kinetic energy q_p^2 [m²/s²]'\nset style fill solid 0.1 noborder\n"
      "plot 'fig18_paper_axis.csv' skip 1 using 1:2:3 with filledcurves linecolor rgb paper title 'axis of the paper', "
      "'' skip 1 using 1:2 with lines linestyle 1 linewidth 0.8 notitle, '' skip 1 using 1:3 with lines linestyle 1 "
      "linewidth 0.8 notitle" +
      bed + local + "\n";
  draw_figure_of_runs("fig18", script, {520, 470}, context, keys);
  return output;
}

}  // namespace

Figure fig18() {
  return {"fig18", "Fluctuating kinetic energy of the fluidised particles", needs, draw,
          "peng_2014/fig18_fluctuating_energy"};
}

}  // namespace slfb
