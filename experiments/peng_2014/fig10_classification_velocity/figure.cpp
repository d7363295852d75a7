#include <fmt/format.h>

#include <cmath>

#include "correlations/classification/force_balance.hpp"
#include "correlations/drag/drag_laws.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

/// Velocity of the steel sphere through the homogeneous bed of that law if it met no other sphere [m/s]. Not a number
/// where the law has no homogeneous bed.
template <class Law>
double collision_free_velocity(const Law& law, double superficial_velocity) {
  const Sphere glass = paper::glass(0.005);
  const auto bed = fluidisation::bed_voidage(law, glass, paper::water(), superficial_velocity, paper::packed_voidage());
  if (bed.regime != fluidisation::BedRegime::expanded) return std::nan("");
  return classification::force_balance_velocity(
      law, {glass, paper::steel(0.006), paper::water(), bed.voidage, superficial_velocity});
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig10", {}, "", run_notes(context, keys)};
  output.caption =
      "Classification velocity of the 6 mm steel sphere in the bed of 5 mm glass, water: slope of the straight line "
      "through z(t) between 0.1 and 0.2 m. Open circles: the 18 values of the paper's Table 2, one drop each. Filled "
      "symbols: mean of our drops with its 95 % interval, the single drops behind them as pale dots. Thin lines: the "
      "limit "
      "without collisions, where weight, pressure gradient of the homogeneous bed and drag of the named law balance; "
      "what lies below a line is the braking by collisions. Gidaspow's line ends where his law has no homogeneous bed. "
      "The experiments of the paper and its exponential fit are not available as numbers.";

  DataTable paper{"fig10_paper", {"superficial velocity [m/s]", "classification velocity [m/s]", "R^2 [-]"}, {}};
  for (const auto& row : peng_2014().table2())
    paper.rows.push_back({row.superficial_velocity, row.classification_velocity, row.r_squared});
  output.data.push_back(write_csv(paper, context.out));

  DataTable laws{"fig10_without_collisions", {"superficial velocity [m/s]", "Eq. 36 [m/s]", "Gidaspow 1994 [m/s]"}, {}};
  for (int step = 50; step <= 245; ++step) {
    const double velocity = 1e-3 * step;
    laws.rows.push_back({velocity, collision_free_velocity(drag::Doroodchi2012{}, velocity),
                         collision_free_velocity(drag::Gidaspow1994{}, velocity)});
  }
  output.data.push_back(write_csv(laws, context.out));

  std::string faint, means;
  const auto variants = variants_of(context.profile, system_name);
  for (std::size_t place = 0; place < variants.size(); ++place) {
    const std::string tag = variants[place].empty() ? "default" : variants[place];
    const auto points = measured_points(context.measurements, "classification_velocity", system_name, variants[place]);
    if (points.empty()) continue;
    DataTable mean{
        "fig10_mean_" + tag,
        {"superficial velocity [m/s]", "mean classification velocity [m/s]", "half width of its 95 % interval [m/s]"},
        {}};
    for (const auto& point : points) mean.rows.push_back({point.superficial_velocity, point.value, point.half_width});
    DataTable drops{
        "fig10_drops_" + tag, {"superficial velocity [m/s]", "classification velocity [m/s]", "R^2 [-]"}, {}};
    for (const auto& run : context.runs) {
      if (!wanted(run.spec) || run.spec.variant != variants[place]) continue;
      for (const auto& drop : run.result.drops)
        if (const auto fit = fit_classification(drop, 0.0))
          drops.rows.push_back({run.spec.superficial_velocity, fit->velocity, fit->r_squared});
    }
    output.data.push_back(write_csv(mean, context.out));
    output.data.push_back(write_csv(drops, context.out));
    const int style = line_style(place);
    faint += fmt::format(
        "'{}.csv' skip 1 using 1:2 with points linestyle {} pointtype 7 pointsize 0.35 linecolor rgb pale_{} notitle, ",
        drops.name, style, style);
    means += fmt::format(", {}'{}.csv' skip 1 using 1:2 with points linestyle {} title {}",
                         error_bars(mean, {1, 2, 3}, "yerrorbars", style), mean.name, style,
                         gnuplot_text(series_title(context, system_name, variants[place])));
  }
  const std::string script =
      "set key tmargin left vertical maxrows 9 Left reverse font ',12'\nset xrange [0.04:0.25]\nset yrange [0:0.6]\n"
      "set xlabel 'superficial liquid velocity U_L [m/s]'\nset ylabel 'classification velocity V_2 [m/s]'\n"
      "plot " +
      faint +
      "'fig10_without_collisions.csv' skip 1 using 1:2 with lines linestyle 12 title 'without collisions, Eq. 36', "
      "'' skip 1 using 1:3 with lines linestyle 11 title 'without collisions, Gidaspow', "
      "'fig10_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, Table 2'" +
      means + "\n";
  draw_figure_of_runs("fig10", script, {520, 500}, context, keys);
  return output;
}

}  // namespace

Figure fig10() {
  return {"fig10", "Classification velocity against superficial velocity", needs, draw,
          "peng_2014/fig10_classification_velocity"};
}

}  // namespace slfb
