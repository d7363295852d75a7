#include <fmt/format.h>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.variant.empty() && (spec.system == "6in3N" || spec.system == "6in5N" ||
                                    (spec.system == "6in5W" && spec.superficial_velocity > 0.055));
  });
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig12", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Fluctuation u'_L of the interstitial liquid (Eq. 37) in the plane y = 0 between 0.1 and 0.2 m against the "
      "voidage of "
      "the bed, above as the mean length of the vector u − ū, below for its vertical component alone. Open symbols: "
      "glass "
      "of 3 and 5 mm in sodium iodide solution, as in the paper; filled: 5 mm in water. Bars: 95 % intervals. Shaded: "
      "voidages {} to {}, where the paper sees a sharp rise. Neither its simulated nor its measured points (PIV) are "
      "available as numbers.",
      printed.value("fluctuation_rise_begin"), printed.value("fluctuation_rise_end"));
  std::string vector, vertical;
  for (const BedSystem& system : {bed_systems[6], bed_systems[7], bed_systems[2]}) {
    vector += plot_against_bed(
        against_bed(context, "liquid_fluctuation", "mean |u - mean u| [m/s]", system.name, "", BedAbscissa::voidage),
        fmt::format("{:g} mm, {}", 1e3 * system.bed_diameter, system.name.ends_with('N') ? "NaI" : "water"),
        system.line_style, context, output);
    vertical += plot_against_bed(against_bed(context, "liquid_fluctuation_vertical", "mean |u_z - mean u_z| [m/s]",
                                             system.name, "", BedAbscissa::voidage),
                                 "", system.line_style, context, output);
  }
  output.data.push_back(write_csv(
      {"fig12_paper_axis",
       {"voidage [-]", "lowest [m/s]", "highest [m/s]"},
       {{printed.value("fluctuation_rise_begin"), 0.0, 1.0}, {printed.value("fluctuation_rise_end"), 0.0, 1.0}}},
      context.out));
  const std::string band =
      "'fig12_paper_axis.csv' skip 1 using 1:2:3 with filledcurves linecolor rgb paper fillstyle solid 0.08 noborder ";
  const std::string missing =
      vector.empty() ? "set label 1 'no run with this record yet' at graph 0.55, 0.5 font ',12' textcolor rgb quiet\n"
                     : "";
  const std::string script =
      "set multiplot\nset lmargin at screen 0.165\nset rmargin at screen 0.97\nset xrange [0.4:0.9]\nset xtics 0.1\n"
      "middle = base + 0.5*(1 - base - 80.0/height)\nset yrange [0:0.18]\nset ytics 0.04\n"
      "set tmargin at screen 1 - 92.0/height\nset bmargin at screen middle + 22.0/height\nset format x ''\n"
      "set ylabel \"u'_L, vector [m/s]\" offset 0.5,0\nset key at screen 0.165, screen 1 - 8.0/height left top Left "
      "reverse font ',12'\n" +
      missing + "plot " + band + "title 'sharp rise in the paper'" + vector +
      "\neval footer_drawn\nset tmargin at screen middle - 2.0/height\nset bmargin at screen base + 60.0/height\n"
      "set format x '%g'\nset xlabel 'voidage α_L [-]'\nset ylabel \"u'_L, vertical [m/s]\" offset 0.5,0\n"
      "unset key\nplot " +
      band + vertical + "\nunset multiplot\n";
  draw_figure_of_runs("fig12", script, {520, 720}, context, keys);
  return output;
}

}  // namespace

Figure fig12() {
  return {"fig12", "Fluctuation of the liquid's velocity", needs, draw, "peng_2014/fig12_liquid_fluctuation"};
}

}  // namespace slfb
