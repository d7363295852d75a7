#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <string>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/numerics/studies/scheme_study.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "solver/coupling/void_fraction/particle_meshing.hpp"
#include "solver/support/processor.hpp"

namespace slfb::fig01_void_fraction_schemes {
namespace {

const FigureFolder folder{"peng_2014/fig01_void_fraction_schemes"};

using void_fraction_study::Method;
using void_fraction_study::methods;
using void_fraction_study::Outcome;

/// Cells over the side of the assembly, and how often the grid is laid anew; few large cells need it.
struct Width {
  int across, placements;
};
constexpr std::array widths{Width{2, 4},  Width{3, 2},  Width{4, 1},  Width{6, 1}, Width{8, 1},
                            Width{12, 1}, Width{20, 1}, Width{27, 1}, Width{40, 1}};
constexpr int spheres = 8192;
/// Cells of 1.28 diameters: about the 6.25 mm that 5600 cells give, with spheres of 5 mm.
constexpr int across_of_paper = 16;

/// The far half of the template, cut open: equal balls with the volume of a piece, farthest first, one colour per
/// shell.
DataTable template_half(int pieces) {
  auto centres = coupling::meshing_template(pieces);
  std::erase_if(centres, [](const auto& x) { return x[1] < 0.0; });
  std::ranges::sort(centres, std::greater{}, [](const auto& x) { return x[1]; });
  DataTable table{"fig01_template", {"x [radii]", "z [radii]", "radius [radii]", "colour [rgb]"}, {}};
  const double piece = std::cbrt(1.0 / pieces);  // radius of a ball with its volume
  for (const auto& x : centres) {
    // From orange at the centre to blue at the surface, every other shell paler, darker with depth.
    const double distance = std::hypot(x[0], x[1], x[2]);
    const bool pale = static_cast<int>(std::lround(distance / (2.0 * piece))) % 2 == 1;
    const double light = 0.6 + 0.4 * (1.0 - x[1]);
    const std::array<double, 3> inner{235, 120, 20}, outer{20, 110, 180};
    int colour = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double full = std::lerp(inner[c], outer[c], std::min(1.0, distance));
      colour = 256 * colour + static_cast<int>(light * (pale ? std::lerp(full, 255.0, 0.45) : full));
    }
    table.rows.push_back({x[0], x[2], 0.85 * piece, static_cast<double>(colour)});
  }
  return table;
}

/// One column per method after the abscissa.
DataTable table_of_methods(const std::string& name, const std::string& abscissa) {
  DataTable table{name, {abscissa}, {}};
  for (const Method& method : methods()) table.columns.push_back(method.name + " [-]");
  return table;
}

/// Root mean square and largest error over the cell size.
std::array<DataTable, 2> errors(const void_fraction_study::Assembly& assembly) {
  std::array tables{table_of_methods("fig01_root_mean_square", "cell size [diameters]"),
                    table_of_methods("fig01_largest", "cell size [diameters]")};
  for (const Width& width : widths) {
    for (auto& table : tables) table.rows.push_back({assembly.side / width.across});
    for (const Outcome& outcome :
         void_fraction_study::compare(assembly, width.across, width.placements, 0.0, methods())) {
      tables[0].rows.back().push_back(outcome.root_mean_square);
      tables[1].rows.back().push_back(outcome.largest);
    }
  }
  return tables;
}

/// Part of a sphere in a cell, and its change per diameter of way, as the sphere crosses the cell's face.
std::array<DataTable, 2> crossings(double cell) {
  constexpr double step = 0.01;
  constexpr int steps = 150;
  std::array tables{table_of_methods("fig01_crossing", "distance beyond the face [diameters]"),
                    table_of_methods("fig01_rate", "distance beyond the face [diameters]")};
  std::vector<double> places;
  for (int k = 0; k <= steps; ++k) {
    places.push_back(step * (k - 0.5 * steps));
    tables[0].rows.push_back({places.back()});
    if (k < steps) tables[1].rows.push_back({places.back() + 0.5 * step});
  }
  for (const Method& method : methods()) {
    const auto part = void_fraction_study::crossing(method, cell, places);
    for (std::size_t k = 0; k < part.size(); ++k) tables[0].rows[k].push_back(part[k]);
    for (std::size_t k = 0; k + 1 < part.size(); ++k) tables[1].rows[k].push_back((part[k + 1] - part[k]) / step);
  }
  return tables;
}

/// What nothing is both cheaper and nearer than, by rising cost.
DataTable pareto_front(std::vector<Outcome> outcomes) {
  std::ranges::sort(outcomes, {}, &Outcome::nanoseconds);
  DataTable front{"fig01_pareto", {"CPU time [ns per sphere]", "root mean square error [-]"}, {}};
  for (const Outcome& outcome : outcomes)
    if (front.rows.empty() || outcome.root_mean_square < front.rows.back()[1])
      front.rows.push_back({outcome.nanoseconds, outcome.root_mean_square});
  return front;
}

FigureOutput draw(const FigureContext& context) {
  const auto assembly = void_fraction_study::hard_spheres(spheres, 0.5, 1);
  const double paper_cell = assembly.side / across_of_paper;
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const std::string when = fmt::format("{}; {:%F}", processor_name(), fmt::localtime(now));
  FigureOutput output{
      "fig01",
      {},
      folder.caption({{"spheres", fmt::format("{}", spheres)}, {"cell", fmt::format("{:.2f}", paper_cell)}}),
      {fmt::format("CPU times are measured anew at each drawing, here on {}.", when)}};

  const auto [mean, largest] = errors(assembly);
  const auto [crossing, rate] = crossings(paper_cell);
  const auto outcomes = void_fraction_study::compare(assembly, across_of_paper, 1, 0.1, methods());
  DataTable cost{
      "fig01_cost",
      {fmt::format("CPU time on {} [ns per sphere]", when), "root mean square error [-]", "largest error [-]"},
      {}};
  std::vector<std::string> names;
  std::vector<double> costs, mean_errors;
  for (std::size_t m = 0; m < outcomes.size(); ++m) {
    const Outcome& outcome = outcomes[m];
    cost.rows.push_back({outcome.nanoseconds, outcome.root_mean_square, outcome.largest});
    names.push_back(methods()[m].name);
    costs.push_back(outcome.nanoseconds);
    mean_errors.push_back(outcome.root_mean_square);
  }
  for (const DataTable& table : {template_half(1214), mean, largest, cost, pareto_front(outcomes), crossing, rate})
    output.data.push_back(write_csv(table, context.out));

  PlotValues values;
  values.number("paper_cell", paper_cell);
  values.texts("method", names);
  values.numbers("cost", costs);
  values.numbers("error", mean_errors);
  draw_plot("fig01", folder.plot(), values, {1240, 720}, context.out);
  return output;
}

}  // namespace

Figure figure() { return {"fig01", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::fig01_void_fraction_schemes
