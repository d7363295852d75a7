#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/numerics/figures.hpp"
#include "experiments/numerics/pressure_noise/noise_study.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{
      "pressure-noise",
      {},
      "",
      {"Drawn from the committed results of `slfb bench pressure-noise` (experiments/numerics/pressure_noise)."}};
  output.caption =
      "Root mean square of the instantaneous pressure drop about its mean, static head removed, in the bed of 3600 "
      "glass spheres of 5 mm in water at 0.10 m/s (cells of 6.25 mm), against the liquid's time step. Bars: 95 % "
      "intervals from blocks. Spheres that enter a cell by jumps displace liquid at once: that noise grows as the step "
      "shrinks. Computed every 0.5 or 1 ms and led evenly to where the spheres will be, the void fraction has no "
      "jumps, but "
      "its rate has, and what collisions change comes at once. Dotted: the buoyant weight of the bed. Right: the same "
      "over the value at 1 ms with exact overlap.";
  const auto points = noise::load_study(source_folder() / "experiments/numerics/pressure_noise/pressure_noise.csv");
  std::string absolute, relative;
  double weight = 0.0, reference = 1.0;
  for (const auto& p : points)
    if (p.method == noise::methods().front().name && p.time_step > 0.9e-3) reference = p.rms;
  int style = 2;
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
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, context.out));
    const std::string separator = absolute.empty() ? "" : ", ";
    absolute += fmt::format(
        "{}'{}.csv' skip 1 using (1000*$1):2:(1000*$1):(1000*$1):($3 > 10 ? $3 : 10):4 with xyerrorbars linestyle {} "
        "notitle, "
        "'' skip 1 using (1000*$1):2 with lines linestyle {} notitle",
        separator, table.name, style, style);
    relative += fmt::format("{}'{}.csv' skip 1 using (1000*$1):6 with linespoints linestyle {} title '{}'", separator,
                            table.name, style, method.name);
    ++style;
  }
  draw_figure("pressure-noise",
              fmt::format("set multiplot layout 1,2 margins 0.115,0.985,0.17,0.95 spacing 0.115,0\n"
                          "set logscale xy\nset xrange [0.08:1.25]\nset xtics (0.1, 0.2, 0.5, 1)\n"
                          "set xlabel 'time step of the liquid [ms]'\nset ylabel 'r.m.s. of the pressure drop [Pa]'\n"
                          "unset key\nset yrange [10:2e4]\n"
                          "plot {:.6g} with lines linestyle 20 notitle, {}\n"
                          "set ylabel 'over exact overlap at 1 ms [-]'\nset yrange [0.8:2000]\n"
                          "set key top right Right font ',12'\n"
                          "plot 1 with lines linestyle 20 notitle, {}\nunset multiplot\n",
                          weight, absolute, relative),
              {820, 380}, context.out);
  return output;
}

}  // namespace

Figure pressure_noise() {
  return {"pressure-noise", "Noise of the pressure drop: void-fraction schemes at long and short steps", no_runs, draw,
          "numerics/pressure_noise"};
}

}  // namespace slfb
