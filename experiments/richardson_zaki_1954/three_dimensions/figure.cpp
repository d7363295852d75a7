#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/richardson_zaki_1954/beds.hpp"
#include "experiments/richardson_zaki_1954/figures.hpp"
#include "experiments/richardson_zaki_1954/numbers.hpp"
#include "experiments/richardson_zaki_1954/simulations.hpp"
#include "experiments/richardson_zaki_1954/work.hpp"
#include "experiments/runs/measure.hpp"
#include "experiments/work/profiles.hpp"

namespace slfb::richardson_zaki::three_dimensions {
namespace {

const FigureFolder folder{"richardson_zaki_1954/three_dimensions"};

/// Errors of the voidage of one law in one model.
struct Errors {
  std::vector<double> of_beds = {};  ///< mean over the points of a bed
  double squares = 0.0, worst = 0.0;
  int points = 0;

  void add_bed(const std::vector<double>& errors) {
    if (errors.empty()) return;
    double sum = 0.0;
    for (const double error : errors) {
      sum += error;
      squares += error * error;
      worst = std::max(worst, std::abs(error));
      ++points;
    }
    of_beds.push_back(sum / static_cast<double>(errors.size()));
  }
  [[nodiscard]] ReplicateEstimate over_beds() const { return estimate_replicates(of_beds); }
  [[nodiscard]] double root_mean_square() const { return std::sqrt(squares / points); }
};

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"three-dimensions", {}, "", {}};
  const Profile laws_profile = load_profile(richardson_zaki_1954_work(), "laws");
  const Measurements of_laws =
      measure_runs(finished_runs(laws_profile, context.results), richardson_zaki_1954_work().measuring);
  std::vector<std::string> laws{scene_law};
  laws.insert(laws.end(), near_laws.begin(), near_laws.end());

  DataTable homogeneous{"three_dimensions_homogeneous",
                        {"law [-]", "mean error of the voidage [-]", "half width of its 95 % interval [-]",
                         "root mean square [-]", "largest [-]", "points [-]"},
                        {}},
      simulated{"three_dimensions_simulated", homogeneous.columns, {}};
  std::string rows;
  std::size_t missing = 0;
  std::vector<std::string> drawn;
  double largest_shift = 0.0;
  for (const std::string& law : laws) {
    const bool of_scenes = law == scene_law;
    Errors root, run;
    for (const ExpansionLine& line : beds()) {
      std::vector<double> of_root, of_run;
      for (const double voidage : quick_voidages) {
        const double velocity = run_velocity(line, voidage);
        const auto key = measure_key("voidage_centre_of_mass", line.name, velocity, of_scenes ? "" : law);
        const Measurements& measured = of_scenes ? context.measurements : of_laws;
        const auto found = measured.find(key);
        if (found == measured.end()) {
          ++missing;
          continue;
        }
        of_run.push_back(found->second.value - voidage);
        of_root.push_back(context.measurements.at(measure_key("homogeneous_voidage", law, velocity, line.name)).value -
                          voidage);
      }
      root.add_bed(of_root);
      run.add_bed(of_run);
    }
    if (run.points == 0) continue;
    drawn.push_back(law);
    const auto place = static_cast<double>(drawn.size());
    const ReplicateEstimate still = root.over_beds(), moving = run.over_beds();
    homogeneous.rows.push_back(
        {place - 0.08, still.mean, still.half_width, root.root_mean_square(), root.worst, double(root.points)});
    simulated.rows.push_back(
        {place + 0.08, moving.mean, moving.half_width, run.root_mean_square(), run.worst, double(run.points)});
    largest_shift = std::max(largest_shift, std::abs(moving.mean - still.mean));
    rows += fmt::format("| {} | {:+.3f} ± {:.3f} | {:.3f} | {:+.3f} ± {:.3f} | {:.3f} | {:.3f} | {} |\n", law,
                        still.mean, still.half_width, root.root_mean_square(), moving.mean, moving.half_width,
                        run.root_mean_square(), run.worst, run.points);
  }
  output.caption = folder.caption(
      {{"trend", drawn.empty() ? std::string("Nothing has been simulated yet.")
                               : fmt::format("Simulated beds differ from homogeneous ones by up to {:.3f} in the mean.",
                                             largest_shift)}});
  if (missing > 0) output.notes.push_back(fmt::format("Not simulated yet: {} points.", missing));
  output.findings =
      "| law | homogeneous: mean | r.m.s. | three dimensions: mean | r.m.s. | largest | points "
      "|\n|---|---|---|---|---|---|---|\n" +
      rows + "\n";
  PlotValues values;
  values.texts("law", drawn);
  values.number("law_count", static_cast<double>(drawn.size()));
  values.number("band", 2.0 * voidage_band());
  add_series(
      "series",
      {{std::move(homogeneous), "homogeneous bed", 5}, {std::move(simulated), "simulated in three dimensions", 2}},
      values, context, output);
  draw_plot("three-dimensions", folder.plot(), values, {620, 460}, context.out);
  return output;
}

}  // namespace

Figure figure() { return {"three-dimensions", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::richardson_zaki::three_dimensions
