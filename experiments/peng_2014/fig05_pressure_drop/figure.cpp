#include <fmt/format.h>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/materials.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";

/// The bed of the figure.
const Sphere& glass() {
  static const Sphere sphere = paper::glass(0.005);
  return sphere;
}

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile,
                         [](const RunSpec& spec) { return spec.system == system_name && spec.variant.empty(); });
}

/// What a fluidised bed carries [Pa].
double bed_weight() { return paper::bed_weight_pressure(paper::glass_density); }

/// Pressure drop [Pa] of the packed bed: dp/L = β w / ε on the interstitial velocity w = U/ε.
template <class Law>
double packed_pressure_drop(const Law& law, double voidage, double superficial_velocity) {
  const double slip = superficial_velocity / voidage;
  const double reynolds = reynolds_number(paper::water(), glass().diameter, superficial_velocity);
  const double coefficient =
      drag::exchange_coefficient(law({voidage, reynolds}), voidage, glass().diameter, paper::water().viscosity);
  const double height =
      peng_2014().value("fluidised_mass_text") / glass().density / paper::column_area() / (1.0 - voidage);
  return height * coefficient * slip / voidage;
}

struct PackedLine {
  double voidage;
  std::string title;
  std::string file;
  int style;
};

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig05", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Pressure drop over the bed of 5 mm glass in water, static head removed, against the superficial velocity; "
      "below, the "
      "crossing of the packed-bed line with the plateau, enlarged. Thin lines: Ergun's packed bed at the two "
      "voidages that the paper's own numbers imply (0.400 from the bed height, 0.425 from its packed solids fraction), "
      "up "
      "to the weight of the bed, {:.1f} Pa. Dashed black: the two straight lines that the paper fits to its "
      "simulation. "
      "Triangles mark minimum fluidisation by Eq. 36. A steady fluidised bed cannot carry more than its weight, yet "
      "the "
      "paper's plateau lies above it. The single points of the paper are not available as numbers.",
      bed_weight());

  std::vector<PackedLine> lines{{0.400, "Ergun, voidage 0.400", "fig05_ergun_0.400", 12},
                                {0.425, "Ergun, voidage 0.425", "fig05_ergun_0.425", 13}};
  const auto settled = mean_over_runs(context.measurements, "packed_voidage", system_name);
  if (settled)
    lines.push_back({*settled, fmt::format("Ergun, as settled here, {:.3f}", *settled), "fig05_ergun_settled", 14});

  std::string curves;
  for (const auto& line : lines) {
    DataTable table{line.file, {"superficial velocity [m/s]", "pressure drop [Pa]"}, {}};
    const double end =
        fluidisation::minimum_fluidisation_velocity(drag::Ergun1952{}, glass(), paper::water(), line.voidage);
    constexpr int steps = 60;
    for (int step = 0; step <= steps; ++step) {
      const double velocity = end * step / steps;
      table.rows.push_back({velocity, packed_pressure_drop(drag::Ergun1952{}, line.voidage, velocity)});
    }
    output.data.push_back(write_csv(table, context.out));
    curves += fmt::format("'{}.csv' skip 1 using 1:2 with lines linestyle {} title {}, ", line.file, line.style,
                          gnuplot_text(line.title));
  }

  const double slope = printed.value("packed_line_slope");
  const double intercept = printed.value("packed_line_intercept");
  const double plateau = printed.value("pressure_plateau");
  const double crossing = (plateau - intercept) / slope;
  output.data.push_back(write_csv({"fig05_paper",
                                   {"superficial velocity [m/s]", "pressure drop [Pa]"},
                                   {{-intercept / slope, 0.0}, {crossing, plateau}, {0.24, plateau}}},
                                  context.out));
  DataTable crossings{
      "fig05_minimum_fluidisation", {"voidage [-]", "superficial velocity [m/s]", "pressure drop [Pa]"}, {}};
  for (const auto& line : lines)
    crossings.rows.push_back(
        {line.voidage,
         fluidisation::minimum_fluidisation_velocity(drag::Doroodchi2012{}, glass(), paper::water(), line.voidage),
         bed_weight()});
  output.data.push_back(write_csv(crossings, context.out));

  std::string simulated;
  const auto points = measured_points(context.measurements, "pressure_drop", system_name);
  if (!points.empty()) {
    DataTable table{"fig05_simulated",
                    {"superficial velocity [m/s]", "mean pressure drop [Pa]", "half width of its 95 % interval [Pa]"},
                    {}};
    for (const auto& point : points) table.rows.push_back({point.superficial_velocity, point.value, point.half_width});
    output.data.push_back(write_csv(table, context.out));
    simulated = fmt::format(", {}'fig05_simulated.csv' skip 1 using 1:2 with points linestyle 2 title {}",
                            error_bars(table, {1, 2, 3}, "yerrorbars", 2),
                            gnuplot_text(series_title(context, system_name, "")));
  }
  const std::string plot =
      "plot " + curves + "weight with lines linestyle 11 title sprintf('weight of the bed, %.0f Pa', weight), " +
      "'fig05_paper.csv' skip 1 using 1:2 with lines linestyle 1 title 'paper, fitted lines', " +
      "'fig05_minimum_fluidisation.csv' skip 1 using 2:3 with points pointtype 11 pointsize 0.9 linecolor rgb law_one "
      "title 'U_{mf} by Eq. 36 at these voidages'" +
      simulated + "\n";
  const std::string script = fmt::format(
      "weight = {0:.6g}\nset multiplot\nset lmargin at screen 0.155\nset rmargin at screen 0.965\n"
      "set ylabel 'pressure drop Δp [Pa]' offset 1.6,0\nset xlabel 'superficial liquid velocity U_L [m/s]' offset "
      "0,0.2\n"
      "split = base + 0.42*(1 - base)\nset tmargin at screen 1 - 12.0/height\nset bmargin at screen split + "
      "40.0/height\n"
      "set xrange [0:0.25]\nset yrange [0:1800]\nset xtics 0.05\nset ytics 400\n"
      "set key at graph 0.99, graph 0.03 bottom right reverse Left font ',11' spacing 1.05\n{1}eval footer_drawn\n"
      "set tmargin at screen split - 24.0/height\nset bmargin at screen base + 74.0/height\n"
      "set xrange [0.034:0.066]\nset yrange [1000:1600]\nset xtics 0.04, 0.01\nset ytics 200\nunset key\n"
      "set arrow 1 from {2:.6g}, graph 0 to {2:.6g}, {3:.6g} nohead linestyle 1 linewidth 0.8\n"
      "set label 1 'paper: U_{{mf}} = {2:.4f} m/s' at {2:.6g}, {3:.6g} offset 0,0.8 font ',11'\n{1}unset multiplot\n",
      bed_weight(), plot, crossing, plateau);
  draw_figure_of_runs("fig05", script, {520, 730}, context, keys);
  return output;
}

}  // namespace

Figure fig05() {
  return {"fig05", "Pressure drop and minimum fluidisation", needs, draw, "peng_2014/fig05_pressure_drop"};
}

}  // namespace slfb
