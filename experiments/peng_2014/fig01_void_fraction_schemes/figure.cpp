#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>

#include "experiments/figures/figure_support.hpp"
#include "experiments/numerics/studies/scheme_study.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "solver/coupling/void_fraction.hpp"

namespace slfb {
namespace {

using void_fraction_study::Method;
using void_fraction_study::methods;
using void_fraction_study::Outcome;

std::string processor() {
  std::ifstream cpu_info("/proc/cpuinfo");
  for (std::string line; std::getline(cpu_info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unnamed processor";
}

/// gnuplot's look of a method, and where its name stands beside its point in the plot of error against cost.
struct Look {
  const char* line;
  const char* label = "left offset 0.9,0.4";
};
/// In the order of methods(): meshing in ever darker orange, with diffusion dashed.
constexpr std::array looks{
    Look{"linecolor rgb second_variant linewidth 2 pointtype 9 pointsize 0.8"},
    Look{"linecolor rgb '#f3c39b' linewidth 2 pointtype 5 pointsize 0.6", "right offset -0.9,-0.3"},
    Look{"linecolor rgb '#eb9f5e' linewidth 2 pointtype 5 pointsize 0.6", "right offset -0.9,-0.3"},
    Look{"linecolor rgb '#e07b26' linewidth 2 pointtype 5 pointsize 0.6"},
    Look{"linecolor rgb variant linewidth 2.6 pointtype 5 pointsize 0.8"},
    Look{"linecolor rgb '#8a3c00' linewidth 2 pointtype 5 pointsize 0.6"},
    Look{"linecolor rgb ours linewidth 2.2 pointtype 7 pointsize 1", "left offset 0.9,0.6"},
    Look{"linecolor rgb second_variant linewidth 1.6 pointtype 8 pointsize 0.9 dashtype (6, 4)"},
    Look{"linecolor rgb ours linewidth 1.6 pointtype 6 pointsize 0.8 dashtype (6, 4)", "left offset 0.9,-0.1"}};

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
  auto centres = coupling::VolumeShares::meshing_template(pieces);
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
    for (const Outcome& outcome : compare(assembly, width.across, width.placements, 0.0, methods())) {
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

constexpr std::size_t first_style = 101;  ///< gnuplot's line styles of the methods begin here

using Places = std::vector<std::size_t>;  ///< in methods()

/// Plot elements of the methods `shown`; those of `named` are in the key.
std::string curves(const DataTable& table, const char* style, const Places& shown, const Places& named) {
  std::string plot;
  for (const std::size_t m : shown) {
    const bool in_key = std::ranges::find(named, m) != named.end();
    plot += fmt::format("{}'{}.csv' skip 1 using 1:{} with {} linestyle {} {}", plot.empty() ? "" : ", ", table.name,
                        m + 2, style, first_style + m, in_key ? "title " + gnuplot_text(methods()[m].name) : "notitle");
  }
  return plot;
}

std::vector<std::string> needs(const Profile&) { return {}; }

FigureOutput draw(const FigureContext& context) {
  const auto assembly = void_fraction_study::hard_spheres(spheres, 0.5, 1);
  const double paper_cell = assembly.side / across_of_paper;
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const std::string when = fmt::format("{}; {:%F}", processor(), fmt::localtime(now));
  FigureOutput output{"fig01", {}, "", {fmt::format("CPU times are measured anew at each drawing, here on {}.", when)}};
  output.caption = fmt::format(
      "Above, left: a meshing template of 1214 pieces of equal volume, as many as in the paper's, cut open. Beside it: "
      "error of a cell's solids fraction against exact overlap, over the mean, in a random assembly of {} spheres at a "
      "solids fraction of 0.5; dotted: the 50 % that the paper gives for the centroid method. Diffusion: smoothing "
      "with "
      "a bandwidth of one diameter, which leaves exact overlap on purpose. Below: error against CPU time on one core "
      "with the Pareto front, in cells of {:.2f} diameters; a sphere that crosses the face of such a cell, and the "
      "rate "
      "of change over steps of 0.01 diameters, which drives the liquid through continuity.",
      spheres, paper_cell);

  const auto [mean, largest] = errors(assembly);
  const auto [crossing, rate] = crossings(paper_cell);
  const auto outcomes = compare(assembly, across_of_paper, 1, 0.1, methods());
  DataTable cost{
      "fig01_cost",
      {fmt::format("CPU time on {} [ns per sphere]", when), "root mean square error [-]", "largest error [-]"},
      {}};
  constexpr double lower_edge = 2e-4;  // where exact overlap stands, whose error is zero here
  std::string styles, labels, points;
  for (std::size_t m = 0; m < outcomes.size(); ++m) {
    const Outcome& outcome = outcomes[m];
    cost.rows.push_back({outcome.nanoseconds, outcome.root_mean_square, outcome.largest});
    styles += fmt::format("set style line {} {}\n", first_style + m, looks[m].line);
    labels += fmt::format("set label {} {} at {:.6g},{:.6g} {} font ',11'\n", m + 1, gnuplot_text(methods()[m].name),
                          outcome.nanoseconds, std::max(lower_edge, outcome.root_mean_square), looks[m].label);
    points += fmt::format(
        ", 'fig01_cost.csv' skip 1 every ::{0}::{0} using 1:($2 > lower ? $2 : lower) with points linestyle {1}", m,
        first_style + m);
  }
  for (const DataTable& table : {template_half(1214), mean, largest, cost, pareto_front(outcomes), crossing, rate})
    output.data.push_back(write_csv(table, context.out));

  const Places erring{0, 7, 8, 1, 2, 3, 4, 5}, meshing{1, 2, 3, 4, 5}, entering{0, 1, 2, 4, 7, 8, 6},
      changing{0, 2, 4, 7, 8, 6};
  const std::string commands = fmt::format(
      "{}lower = {}\nset multiplot layout 2,3 margins 0.055,0.988,0.085,0.945 spacing 0.066,0.155\n"
      "set title 'template of 1214 pieces of equal volume'\nunset border\nunset tics\nunset key\nunset grid\n"
      "set size ratio -1\nset xrange [-1.1:1.1]\nset yrange [-1.1:1.1]\nset style fill solid 1 border rgb '#1b2a38'\n"
      "plot 'fig01_template.csv' skip 1 using 1:2:3:4 with circles linecolor rgb variable linewidth 0.4\n"
      "set size noratio\nset border 3\nset grid back\nset logscale xy\nset mxtics 1\nset mytics 1\n"
      "set xrange [0.45:11]\nset xtics nomirror out scale 0.6 (0.5, 1, 2, 5, 10)\n"
      "set yrange [1e-5:10]\nset ytics nomirror out scale 0.6\nset format y '10^{{%L}}'\n"
      "set xlabel 'cell size / sphere diameter'\nset ylabel 'error of solids fraction / mean [-]' offset 0.4,0\n"
      "set title 'root mean square error'\nset key bottom left reverse Left samplen 1.6 spacing 1 font ',11'\nplot {}\n"
      "set title 'largest error'\n"
      "set label 50 '50 %' at 10.5,0.5 right offset 0,0.6 font ',11' textcolor rgb quiet\n"
      "plot 0.5 with lines linestyle 20 notitle, {}\nunset label 50\n"
      "set title 'error against cost, cells of {:.2f} d'\nunset key\nset xrange [10:1e6]\nset xtics autofreq\n"
      "set format x '10^{{%L}}'\nset xlabel 'CPU time per sphere [ns]'\nset yrange [lower:3]\n"
      "set ylabel 'root mean square error [-]' offset 0.8,0\n{}"
      "plot 'fig01_pareto.csv' skip 1 using 1:($2 > lower ? $2 : lower) with steps linestyle 20{}\n"
      "do for [m=1:{}] {{ unset label m }}\nunset logscale\nset format '%g'\nset xrange [-0.75:0.75]\nset xtics 0.25\n"
      "set xlabel 'distance of the centre beyond the face / d'\nset title 'a sphere enters a cell'\n"
      "set ylabel 'part of the sphere in the cell [-]' offset 0,0\nset yrange [-0.02:1.04]\n"
      "set key top left reverse Left samplen 1.6 spacing 1 font ',10'\nplot {}\n"
      "set title 'its rate of change'\nset ylabel 'rate of change per diameter [-]'\nset yrange [-0.15:5]\n"
      "unset key\nset label 51 'centroid: 100' at 0.03,4.7 font ',11' textcolor rgb second_variant\n"
      "plot {}\nunset multiplot\n",
      styles, lower_edge, curves(mean, "linespoints", erring, meshing),
      curves(largest, "linespoints", erring, {0, 7, 8}), paper_cell, labels, points, outcomes.size(),
      curves(crossing, "lines", entering, entering), curves(rate, "lines", changing, {}));
  draw_figure("fig01", commands, {1240, 720}, context.out);
  return output;
}

}  // namespace

Figure fig01() {
  return {"fig01", "Void-fraction schemes: error and cost against exact overlap", needs, draw,
          "peng_2014/fig01_void_fraction_schemes"};
}

}  // namespace slfb
