#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/numerics/figures.hpp"
#include "experiments/numerics/pressure_noise/noise_study.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

const FigureFolder folder{"numerics/pressure_noise"};

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{
      "pressure-noise",
      {},
      folder.caption(),
      {"Drawn from the committed results of `slfb bench pressure-noise` (experiments/numerics/pressure_noise)."}};
  const auto points = noise::load_study(source_folder() / "experiments/numerics/pressure_noise/pressure_noise.csv");
  double weight = 0.0, reference = 1.0;
  for (const auto& p : points)
    if (p.method == noise::methods().front().name && p.time_step > 0.9e-3) reference = p.rms;
  std::vector<Series> series;
  for (const noise::Method& method : noise::methods()) {
    std::string file = method.name;
    std::replace(file.begin(), file.end(), ' ', '_');
    DataTable table{"pressure-noise_" + file,
                    {"liquid time step [s]", "root mean square [Pa]", "low [Pa]", "high [Pa]",
                     "mean pressure drop [Pa]", "over exact overlap at 1 ms [-]"},
                    {}};
    std::set<std::string> failures;
    for (const auto& p : points) {
      if (p.method != method.name) continue;
      weight = p.bed_weight;
      if (p.failure.empty())
        table.rows.push_back({p.time_step, p.rms, p.low, p.high, p.mean, p.rms / reference});
      else
        failures.insert(fmt::format("{} at {:g} ms: {}", method.name, 1000.0 * p.time_step, p.failure));
    }
    for (const std::string& failure : failures) output.notes.push_back("Broke down: " + failure);
    const int style = 2 + static_cast<int>(series.size());
    if (!table.rows.empty()) series.push_back({std::move(table), method.name, style});
  }
  PlotValues values;
  values.number("weight", weight);
  add_series("series", series, values, context, output);
  draw_plot("pressure-noise", folder.plot(), values, {820, 380}, context.out);
  return output;
}

}  // namespace

Figure pressure_noise() { return {"pressure-noise", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb
