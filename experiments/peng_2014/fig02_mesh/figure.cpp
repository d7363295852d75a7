#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/fluid/column_grid.hpp"
#include "solver/support/folders.hpp"

namespace slfb::fig02_mesh {
namespace {

const FigureFolder folder{"peng_2014/fig02_mesh"};

constexpr double part_height = 0.1;  ///< of the column that is drawn with its mesh [m]

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
  const double hexahedra = peng_2014().value("cell_count");
  const double paper_cell = std::cbrt(grid.section_area() * grid.column_height() / hexahedra);
  FigureOutput output{"fig02",
                      {},
                      folder.caption({{"section_cells", fmt::format("{}", grid.cells())},
                                      {"layers", fmt::format("{}", grid.layers())},
                                      {"cells", fmt::format("{}", grid.size())},
                                      {"square", fmt::format("{:.2f}", 1e3 * grid.spacing(0))},
                                      {"paper_cells", fmt::format("{:g}", hexahedra)},
                                      {"paper_cell", fmt::format("{:.2f}", 1e3 * paper_cell)}}),
                      {"No simulation stands behind this picture."}};
  const DataTable section = section_edges(grid), side = side_edges(grid), joined = joined_squares(grid);
  for (const auto* table : {&section, &side, &joined}) output.data.push_back(write_csv(*table, context.out));

  PlotValues values;
  values.number("radius", 1e3 * grid.radius());
  values.number("column_height", 1e3 * grid.column_height());
  values.number("part", 1e3 * part_height);
  values.number("steel", 1e3 * species[1].diameter);
  values.number("glass", 1e3 * species[0].diameter);
  draw_plot("fig02", folder.plot(), values, {760, 380}, context.out);
  return output;
}

}  // namespace

Figure figure() { return {"fig02", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::fig02_mesh
