#include <fmt/format.h>

#include <cmath>

#include "correlations/classification/force_balance.hpp"
#include "correlations/drag/drag_laws.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/quantities/analysis.hpp"

namespace slfb::fig10_classification_velocity {
namespace {

const FigureFolder folder{"peng_2014/fig10_classification_velocity"};

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
  FigureOutput output{"fig10", {}, folder.caption(), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::velocity}, context, output);

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

  std::vector<Series> means, single_drops;
  const auto variants = variants_of(context.profile, system_name);
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const std::string tag = variants[k].empty() ? "default" : variants[k];
    DataTable mean{
        "fig10_mean_" + tag,
        {"superficial velocity [m/s]", "mean classification velocity [m/s]", "half width of its 95 % interval [m/s]"},
        {}};
    DataTable drops{
        "fig10_drops_" + tag, {"superficial velocity [m/s]", "classification velocity [m/s]", "R^2 [-]"}, {}};
    for (const auto& point : measured_points(context.measurements, "classification_velocity", system_name, variants[k]))
      mean.rows.push_back({point.superficial_velocity, point.value, point.half_width});
    for (const auto& run : context.runs) {
      if (!wanted(run.spec) || run.spec.variant != variants[k]) continue;
      for (const auto& drop : run.result.drops)
        if (const auto fit = classification_of(drop, run.scene, peng_2014_work().measuring))
          drops.rows.push_back({run.spec.superficial_velocity, fit->velocity, fit->r_squared});
    }
    means.push_back({std::move(mean), series_title(context, system_name, variants[k]), line_style(k)});
    single_drops.push_back({std::move(drops), "", line_style(k)});
  }
  PlotValues values;
  add_series("mean", means, values, context, output);
  add_series("drops", single_drops, values, context, output);
  draw_plot_of_runs("fig10", folder.plot(), values, {520, 500}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig10", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig10_classification_velocity
