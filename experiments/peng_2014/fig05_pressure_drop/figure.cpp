#include <fmt/format.h>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/materials.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig05_pressure_drop {
namespace {

const FigureFolder folder{"peng_2014/fig05_pressure_drop"};
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
  std::string title, file;
};

DataTable pressure_drops(const char* name, const Measurements& measurements) {
  DataTable table{
      name, {"superficial velocity [m/s]", "mean pressure drop [Pa]", "half width of its 95 % interval [Pa]"}, {}};
  for (const auto& point : measured_points(measurements, "pressure_drop", system_name))
    table.rows.push_back({point.superficial_velocity, point.value, point.half_width});
  return table;
}

/// Beds that were fluidised before the flow was taken down.
Measurements measure_defluidised(const std::filesystem::path& results) {
  std::vector<FinishedRun> runs = finished_runs(load_profile("defluidised"), results);
  std::erase_if(runs, [](const FinishedRun& run) { return run.stale; });
  return measure_runs(runs, peng_2014_work().measuring);
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{
      "fig05", {}, folder.caption({{"weight", fmt::format("{:.1f}", bed_weight())}}), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::pressure_drop}, context, output);
  PlotValues values;
  values.number("weight", bed_weight());

  std::vector<PackedLine> lines{{0.400, "Ergun, voidage 0.400", "fig05_ergun_0.400"},
                                {0.425, "Ergun, voidage 0.425", "fig05_ergun_0.425"}};
  const auto settled = mean_over_runs(context.measurements, "packed_voidage", system_name);
  if (settled)
    lines.push_back({*settled, fmt::format("Ergun, as settled here, {:.3f}", *settled), "fig05_ergun_settled"});
  DataTable crossings{
      "fig05_minimum_fluidisation", {"voidage [-]", "superficial velocity [m/s]", "pressure drop [Pa]"}, {}};
  std::vector<Series> packed;
  for (const PackedLine& line : lines) {
    DataTable table{line.file, {"superficial velocity [m/s]", "pressure drop [Pa]"}, {}};
    const double end =
        fluidisation::minimum_fluidisation_velocity(drag::Ergun1952{}, glass(), paper::water(), line.voidage);
    constexpr int steps = 60;
    for (int step = 0; step <= steps; ++step) {
      const double velocity = end * step / steps;
      table.rows.push_back({velocity, packed_pressure_drop(drag::Ergun1952{}, line.voidage, velocity)});
    }
    packed.push_back({std::move(table), line.title, 12 + static_cast<int>(packed.size())});
    crossings.rows.push_back(
        {line.voidage,
         fluidisation::minimum_fluidisation_velocity(drag::Doroodchi2012{}, glass(), paper::water(), line.voidage),
         bed_weight()});
  }
  add_series("packed", packed, values, context, output);

  const double slope = printed.value("packed_line_slope");
  const double intercept = printed.value("packed_line_intercept");
  const double plateau = printed.value("pressure_plateau");
  const double crossing = (plateau - intercept) / slope;
  values.number("crossing", crossing);
  values.number("plateau", plateau);
  output.data.push_back(write_csv({"fig05_paper",
                                   {"superficial velocity [m/s]", "pressure drop [Pa]"},
                                   {{-intercept / slope, 0.0}, {crossing, plateau}, {0.24, plateau}}},
                                  context.out));
  output.data.push_back(write_csv(crossings, context.out));

  std::vector<Series> simulated{
      {pressure_drops("fig05_simulated", context.measurements), series_title(context, system_name, ""), 2}};
  DataTable defluidised = pressure_drops("fig05_defluidised", measure_defluidised(context.results));
  if (!defluidised.rows.empty()) simulated.push_back({std::move(defluidised), "here, fluidised at 0.10 m/s first", 5});
  add_series("simulated", simulated, values, context, output);

  draw_plot_of_runs("fig05", folder.plot(), values, {520, 730}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig05", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig05_pressure_drop
