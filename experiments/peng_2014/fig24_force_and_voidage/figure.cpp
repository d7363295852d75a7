#include <fmt/format.h>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::fig24_force_and_voidage {
namespace {

const FigureFolder folder{"peng_2014/fig24_force_and_voidage"};
constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig24", {}, folder.caption(), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::force_ratio, grid_convergence::voidage}, context, output);
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

  PlotValues values;
  add_series("mean_of_magnitude",
             variants_against_bed("fig24", "collision_force_ratio", "mean of the magnitude over weight [-]",
                                  system_name, BedAbscissa::voidage, context),
             values, context, output);
  DataTable of_mean = against_bed(context, "collision_force_ratio_of_mean", "magnitude of the mean over weight [-]",
                                  system_name, "", BedAbscissa::voidage);
  of_mean.name = "fig24_" + of_mean.name;
  add_series("magnitude_of_mean", {{std::move(of_mean), "magnitude of the mean force", 2}}, values, context, output);
  draw_plot_of_runs("fig24", folder.plot(), values, {520, 480}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig24", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig24_force_and_voidage
