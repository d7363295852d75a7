#include <fmt/format.h>

#include <array>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

/// The system of the paper, and the one of most other figures beside it.
bool wanted(const RunSpec& spec) {
  return spec.variant.empty() && spec.superficial_velocity > 0.03 &&
         (spec.system == "6in3W" || (spec.system == "6in5W" && spec.superficial_velocity > 0.055));
}

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig16", {}, "", run_notes(context, keys)};
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  output.caption =
      "Spheres in contact with the 6 mm steel sphere during its passage of the bed, mean over time (above) and most at "
      "once (below), against the voidage. Open black circles: the five numbers that the paper prints (6 in 3 mm). "
      "Filled "
      "symbols: our runs, means over the drops with 95 % intervals, for the paper's bed of 3 mm and for that of 5 mm.";
  output.data.push_back(
      write_csv({"fig16_paper",
                 {"voidage [-]", "mean contacts [-]", "most contacts [-]"},
                 {{0.45, printed.value("mean_contacts_dense"), printed.value("maximum_contacts_dense")},
                  {0.65, std::nan(""), printed.value("maximum_contacts_dilute")},
                  {0.79, printed.value("mean_contacts_dilute"), printed.value("maximum_contacts_dilute")}}},
                context.out));
  std::array<std::string, 2> simulated;
  const std::array quantities{"mean_contacts", "maximum_contacts"};
  for (const BedSystem& system : {bed_systems[0], bed_systems[2]})
    for (std::size_t panel = 0; panel < quantities.size(); ++panel)
      simulated[panel] += plot_against_bed(
          against_bed(context, quantities[panel], "contacts [-]", system.name, "", BedAbscissa::voidage),
          panel == 0 ? std::string(system.title) : "", system.line_style, context, output);
  const std::string script =
      "set multiplot\nset lmargin at screen 0.13\nset rmargin at screen 0.97\nset xrange [0.42:0.86]\nset xtics 0.1\n"
      "middle = base + 0.5*(1 - base)\n"
      "set tmargin at screen 1 - 12.0/height\nset bmargin at screen middle + 22.0/height\nset format x ''\n"
      "set logscale y\nset yrange [0.02:10]\nset ylabel 'mean contacts [-]' offset 1.6,0\n"
      "set key top right Left reverse font ',12'\n"
      "plot 'fig16_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, printed'" +
      simulated[0] +
      "\neval footer_drawn\nset tmargin at screen middle - 2.0/height\nset bmargin at screen base + 60.0/height\n"
      "set format x '%g'\nset xlabel 'voidage α_L [-]'\nunset logscale y\nset yrange [0:16]\nset ytics 4\n"
      "set ylabel 'most contacts [-]' offset 0.5,0\nunset key\n"
      "plot 'fig16_paper.csv' skip 1 using 1:3 with points linestyle 1 dashtype 1" +
      simulated[1] + "\nunset multiplot\n";
  draw_figure_of_runs("fig16", script, {520, 620}, context, keys, own_springs);
  return output;
}

}  // namespace

Figure fig16() { return {"fig16", "Contacts of the foreign particle", needs, draw, "peng_2014/fig16_contacts"}; }

}  // namespace slfb
