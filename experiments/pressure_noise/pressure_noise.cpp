#include "experiments/pressure_noise/pressure_noise.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "experiments/figure_support.hpp"
#include "experiments/pressure_noise/noise_study.hpp"

namespace slfb {
namespace {

std::vector<std::string> needs(const Profile&) { return {}; }

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{
      "pressure-noise",
      {},
      "",
      {"Drawn from the committed results of `slfb bench pressure-noise` (experiments/pressure_noise)."}};
  output.caption =
      "Root mean square of the instantaneous pressure drop about its mean, static head removed, in a bed of 400 glass "
      "spheres of 5 mm in a 30 mm column of water at 0.10 m/s (cells of 6 mm, semi-implicit exchange), against the "
      "liquid's time step. Bars: 95 % intervals from blocks. Spheres that enter a cell by jumps displace liquid at "
      "once: "
      "that noise grows as the step shrinks. A scheme without points has broken down: by centroids a cell can receive "
      "more solid than it has room for. Dotted: the buoyant weight of the bed. Right: the same over the value at the "
      "longest step.";
  const auto points =
      noise::load_study(std::filesystem::path(SLFB_SOURCE_DIR) / "experiments/pressure_noise/pressure_noise.csv");
  constexpr std::array schemes{VoidFractionScheme::exact_overlap, VoidFractionScheme::particle_meshing,
                               VoidFractionScheme::centroid};
  std::string absolute, relative;
  double weight = 0.0;
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    const std::string name = noise::name_of(schemes[s]);
    DataTable table{"pressure-noise_" + name,
                    {"liquid time step [s]", "root mean square [Pa]", "low [Pa]", "high [Pa]",
                     "mean pressure drop [Pa]", "over the value at the longest step [-]"},
                    {}};
    double longest = 0.0, reference = 1.0;
    for (const auto& p : points)
      if (p.scheme == schemes[s] && p.time_step > longest) longest = p.time_step, reference = p.rms;
    for (const auto& p : points) {
      if (p.scheme != schemes[s]) continue;
      weight = p.bed_weight;
      table.rows.push_back({p.time_step, p.rms, p.low, p.high, p.mean, p.rms / reference});
    }
    if (table.rows.empty()) continue;
    output.data.push_back(write_csv(table, context.out));
    const std::string separator = s == 0 ? "" : ", ";
    absolute += fmt::format(
        "{}'{}.csv' skip 1 using (1000*$1):2:3:4 with yerrorbars linestyle {} title '{}', "
        "'' skip 1 using (1000*$1):2 with lines linestyle {} notitle",
        separator, table.name, s + 2, name, s + 2);
    relative += fmt::format("{}'{}.csv' skip 1 using (1000*$1):6 with linespoints linestyle {} title '{}'", separator,
                            table.name, s + 2, name);
  }
  draw_figure("pressure-noise",
              fmt::format("set multiplot layout 1,2 margins 0.09,0.985,0.17,0.95 spacing 0.11,0\n"
                          "set logscale xy\nset xrange [0.08:1.25]\nset xtics (0.1, 0.2, 0.5, 1)\n"
                          "set xlabel 'time step of the liquid [ms]'\nset ylabel 'r.m.s. of the pressure drop [Pa]'\n"
                          "set key bottom left reverse Left font ',12'\n"
                          "plot {:.6g} with lines linestyle 20 notitle, {}\n"
                          "set ylabel 'over that at 1 ms [-]'\nset key top right\n"
                          "plot 1 with lines linestyle 20 notitle, {}\nunset multiplot\n",
                          weight, absolute, relative),
              {820, 380}, context.out);
  return output;
}

}  // namespace

Figure pressure_noise() {
  return {"pressure-noise", "Noise of the pressure drop: void-fraction schemes at long and short steps", needs, draw,
          "pressure_noise"};
}

}  // namespace slfb
