#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/fluid/column_grid.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

constexpr double part_height = 0.1;  ///< of the column that is drawn with its mesh [m]

std::vector<std::string> needs(const Profile&) { return {}; }

/// Part of a straight line x = offset (or y = offset) between `from` and `to` that lies inside the round wall.
std::pair<double, double> inside_wall(double radius, double offset, double from, double to) {
  const double half = std::sqrt(std::max(0.0, radius * radius - offset * offset));
  return {std::clamp(from, -half, half), std::clamp(to, -half, half)};
}

/// Edges of the section between cells, as segments from a point over a vector.
DataTable section_edges(const fluid::ColumnGrid& grid) {
  DataTable table{"fig02_section", {"x [m]", "y [m]", "dx [m]", "dy [m]"}, {}};
  for (const std::size_t axis : {0U, 1U}) {
    const std::size_t other = 1 - axis;
    for (int line = 1; line < grid.squares(axis); ++line) {
      const double offset = grid.lower(axis) + line * grid.spacing(axis);
      for (int across = 0; across < grid.squares(other); ++across) {
        const auto cell = [&](int along) {
          return axis == 0 ? grid.cell_of_square(along, across) : grid.cell_of_square(across, along);
        };
        if (cell(line - 1) == cell(line)) continue;  // joined across this edge
        const double start = grid.lower(other) + across * grid.spacing(other);
        const auto [from, to] = inside_wall(grid.radius(), offset, start, start + grid.spacing(other));
        if (to - from < 1e-9) continue;
        table.rows.push_back(axis == 0 ? std::vector{offset, from, 0.0, to - from}
                                       : std::vector{from, offset, to - from, 0.0});
      }
    }
  }
  return table;
}

/// Edges of the cells that the plane y = 0 cuts, in the lowest part of the column.
DataTable side_edges(const fluid::ColumnGrid& grid) {
  DataTable table{"fig02_side", {"x [m]", "z [m]", "dx [m]", "dz [m]"}, {}};
  for (int line = 0; line <= grid.squares(0); ++line)
    table.rows.push_back({grid.lower(0) + line * grid.spacing(0), 0.0, 0.0, part_height});
  for (double z = 0.0; z < part_height + 1e-9; z += grid.cell_height())
    table.rows.push_back({-grid.radius(), z, 2.0 * grid.radius(), 0.0});
  return table;
}

/// What lies inside the wall of the squares that are joined to a neighbour, as upright strips: centre and half extents.
DataTable joined_squares(const fluid::ColumnGrid& grid) {
  DataTable table{"fig02_joined", {"x [m]", "y [m]", "half width [m]", "half height [m]"}, {}};
  constexpr int strips = 40;
  const double width = grid.spacing(0) / strips;
  for (int iy = 0; iy < grid.squares(1); ++iy) {
    for (int ix = 0; ix < grid.squares(0); ++ix) {
      const double left = grid.lower(0) + ix * grid.spacing(0), lower = grid.lower(1) + iy * grid.spacing(1);
      const auto own = grid.centre(grid.cell_of_square(ix, iy));
      if (std::hypot(own[0] - left - 0.5 * grid.spacing(0), own[1] - lower - 0.5 * grid.spacing(1)) < 1e-9) continue;
      for (int strip = 0; strip < strips; ++strip) {
        const double x = left + (strip + 0.5) * width;
        const auto [from, to] = inside_wall(grid.radius(), x, lower, lower + grid.spacing(1));
        if (to > from) table.rows.push_back({x, 0.5 * (from + to), 0.5 * width, 0.5 * (to - from)});
      }
    }
  }
  return table;
}

FigureOutput draw(const FigureContext& context) {
  const Scene scene = load_scene(source_folder() / "experiments" / "peng_2014" / "scenes" / "6in5W.toml", {});
  const fluid::ColumnGrid grid(scene);
  const auto& species = scene.species;
  FigureOutput output{"fig02", {}, "", {"No simulation stands behind this picture."}};
  const double paper_cell = std::cbrt(grid.section_area() * grid.column_height() / peng_2014().value("cell_count"));
  output.caption = fmt::format(
      "Domain and mesh of our liquid, from the grid that the simulations use: {} cells in the section times {} layers, "
      "{} "
      "in all, squares of {:.2f} mm cut exactly by the round wall. A cut square of less than half its area is joined "
      "to "
      "its neighbour towards the axis (shaded). The two largest spheres are drawn to scale. The paper has {:g} "
      "hexahedra, "
      "finer towards the wall, {:.2f} mm in the mean; its mesh is a picture only.",
      grid.cells(), grid.layers(), grid.size(), 1e3 * grid.spacing(0), peng_2014().value("cell_count"),
      1e3 * paper_cell);
  const DataTable section = section_edges(grid), side = side_edges(grid), joined = joined_squares(grid);
  for (const auto* table : {&section, &side, &joined}) output.data.push_back(write_csv(*table, context.out));

  const Canvas canvas{760, 380};
  const double radius = 1e3 * grid.radius();
  // One scale within each panel: 270 pixels for 58 mm of the section, 110 mm of the part and 1 m of the domain.
  const std::string script = fmt::format(
      "height = {canvas}.0\nset multiplot\nunset grid\nunset key\nunset border\nunset tics\nset size ratio -1\nmm = "
      "1000.0\n"
      "set style fill solid 0.25 noborder\n"
      "set tmargin at screen 1 - 30.0/height\nset bmargin at screen 26.0/height\nset lmargin at screen 0.01\nset "
      "rmargin at "
      "screen 0.15\nset title 'domain' font ',13' offset 0,-0.4\nset xrange [-80:80]\nset yrange [-70:{height:.6g}]\n"
      "set object 1 rectangle from -{radius:g}, 0 to {radius:g}, {column:g} fillstyle empty border linecolor rgb "
      "'#2b3138' "
      "linewidth 1.2\n"
      "set object 2 rectangle from -{radius:g}, 0 to {radius:g}, {part:g} fillcolor rgb ours fillstyle solid 0.2 "
      "noborder\n"
      "set arrow 1 from 52, 0 to 52, {column:g} heads size 12,20 linecolor rgb quiet\n"
      "set label 1 '{column:g} mm' at 88, {middle:g} rotate by 90 center font ',11'\n"
      "do for [i=-1:1] {{ set arrow 5+i from i*16, -40 to i*16, -4 head size 14,20 linecolor rgb ours }}\n"
      "plot NaN\nunset object 1\nunset object 2\nunset arrow\nunset label 1\n"
      "set lmargin at screen 0.17\nset rmargin at screen 0.42\nset title 'plane y = 0, lowest {part:g} mm'\n"
      "set xrange [-30:30]\nset yrange [-4:{part_top:g}]\n"
      "plot '{side}.csv' skip 1 using (mm*$1):(mm*$2):(mm*$3):(mm*$4) with vectors nohead linecolor rgb '#5b6470' "
      "linewidth "
      "0.8\n"
      "set lmargin at screen 0.44\nset rmargin at screen 0.99\nset title 'section'\n"
      "set xrange [-31:45]\nset yrange [-34:28]\nset trange [0:2*pi]\nset parametric\n"
      "set object 3 circle at -9, 0 size {steel:g} fillcolor rgb '#c0392b' fillstyle solid 0.75 noborder front\n"
      "set object 4 circle at 9, 0 size {glass:g} fillcolor rgb ours fillstyle solid 0.45 noborder front\n"
      "set label 3 '{steel_mm:g} mm' at -9, -5 center font ',11' textcolor rgb '#c0392b' front\n"
      "set label 4 '{glass_mm:g} mm' at 9, -5 center font ',11' textcolor rgb ours front\n"
      "set arrow 2 from -{radius:g}, -29 to {radius:g}, -29 heads size 1.2,20 linecolor rgb quiet\n"
      "set label 2 '{diameter:g} mm' at 0, -32 center font ',11'\n"
      "set label 5 'shaded: joined to' at 28, 25 font ',11' textcolor rgb law_three\n"
      "set label 6 'the next square' at 28, 22 font ',11' textcolor rgb law_three\n"
      "plot '{joined}.csv' skip 1 using (mm*$1):(mm*$2):(mm*$3):(mm*$4) with boxxyerror linecolor rgb law_three, "
      "'{section}.csv' skip 1 using (mm*$1):(mm*$2):(mm*$3):(mm*$4) with vectors nohead linecolor rgb '#5b6470' "
      "linewidth "
      "0.9, {radius:g}*cos(t), {radius:g}*sin(t) with lines linecolor rgb '#14181d' linewidth 1.8\nunset multiplot\n",
      fmt::arg("canvas", canvas.height), fmt::arg("radius", radius), fmt::arg("diameter", 2.0 * radius),
      fmt::arg("column", 1e3 * grid.column_height()), fmt::arg("height", 1e3 * grid.column_height() + 20.0),
      fmt::arg("middle", 500.0 * grid.column_height()), fmt::arg("part", 1e3 * part_height),
      fmt::arg("part_top", 1e3 * part_height + 4.0), fmt::arg("side", side.name), fmt::arg("section", section.name),
      fmt::arg("joined", joined.name), fmt::arg("steel", 500.0 * species[1].diameter),
      fmt::arg("glass", 500.0 * species[0].diameter), fmt::arg("steel_mm", 1e3 * species[1].diameter),
      fmt::arg("glass_mm", 1e3 * species[0].diameter));
  draw_figure("fig02", script, canvas, context.out);
  return output;
}

}  // namespace

Figure fig02() { return {"fig02", "Domain and mesh", needs, draw, "peng_2014/fig02_mesh"}; }

}  // namespace slfb
