#include "solver/fluid/column_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slfb::fluid {
namespace {

/// ∫ xⁿ dA over the circle's part with x <= a and y <= b: its area (n = 0) or its moment (n = 1).
double quadrant_moment(int n, double r, double a, double b) {
  if (a <= -r || b <= -r) return 0.0;
  a = std::min(a, r);
  b = std::min(b, r);
  // ∫ over x from −r to a of xⁿ times the chord below b. Antiderivatives of xⁿ √(r² − x²) and xⁿ.
  const auto primitive = [n, r](double x) {
    const double c = std::clamp(x / r, -1.0, 1.0), root = std::sqrt(std::max(0.0, 1.0 - c * c));
    return n == 0 ? 0.5 * r * r * (c * root + std::asin(c)) : -std::pow(r * root, 3) / 3.0;
  };
  const auto power = [n](double x) { return n == 0 ? x : 0.5 * x * x; };
  // Where |x| > x_b the chord's upper end √(r² − x²) lies below |b|.
  const double x_b = std::sqrt(std::max(0.0, r * r - b * b)), inner_end = std::min(a, x_b);
  const auto between = [&](double x0, double x1) { return x1 > x0 ? primitive(x1) - primitive(x0) : 0.0; };
  const double outer = between(-r, std::min(a, -x_b)) + between(x_b, a);
  const double inner = a > -x_b ? between(-x_b, inner_end) + b * (power(inner_end) - power(-x_b)) : 0.0;
  return b >= 0.0 ? 2.0 * outer + inner : inner;
}

/// ∫ xⁿ dA over the part of a rectangle inside the circle.
double rectangle_moment(int n, double r, double x0, double x1, double y0, double y1) {
  return quadrant_moment(n, r, x1, y1) - quadrant_moment(n, r, x0, y1) - quadrant_moment(n, r, x1, y0) +
         quadrant_moment(n, r, x0, y0);
}

/// Part of the segment y = const from x0 to x1 inside the circle; its end is not above its start where there is none.
std::array<double, 2> segment_inside(double r, double y, double x0, double x1) {
  const double half = std::sqrt(std::max(0.0, r * r - y * y));
  return {std::max(x0, -half), std::min(x1, half)};
}

}  // namespace

double circle_rectangle_area(double radius, double x0, double x1, double y0, double y1) {
  return rectangle_moment(0, radius, x0, x1, y0, y1);
}

bool ColumnGrid::square_inside(int ix, int iy) const {
  if (!cylinder_) return true;
  return std::hypot(lower_[0] + (ix + 0.5) * spacing_[0], lower_[1] + (iy + 0.5) * spacing_[1]) < radius_;
}

double ColumnGrid::wall_distance(const std::array<double, 2>& point, std::size_t axis, std::size_t side) const {
  if (periodic_ || squares_[axis] == 1) return std::numeric_limits<double>::infinity();
  const double half =
      cylinder_ ? std::sqrt(std::max(0.0, radius_ * radius_ - point[1 - axis] * point[1 - axis])) : -lower_[axis];
  return side == 0 ? point[axis] + half : half - point[axis];
}

ColumnGrid::ColumnGrid(const Scene& scene)
    : ColumnGrid(scene, std::max(1, static_cast<int>(std::lround(scene.geometry.height / scene.fluid.cell_height))),
                 scene.fluid.tier == FluidTier::three_dimensional ? scene.fluid.cells_across : 1,
                 scene.fluid.tier == FluidTier::three_dimensional) {}

ColumnGrid ColumnGrid::single_cell(const Scene& scene) { return {scene, 1, 1, false}; }

ColumnGrid::ColumnGrid(const Scene& scene, int layers, int across, bool many_deep) : layers_(layers) {
  const Geometry& geometry = scene.geometry;
  cylinder_ = geometry.shape == Shape::cylinder;
  periodic_ = !cylinder_ && scene.fluid.wall == LateralBoundary::periodic;
  const std::array<double, 2> extent =
      cylinder_ ? std::array<double, 2>{geometry.diameter, geometry.diameter} : geometry.width;
  const double width = extent[0] / across;
  height_ = geometry.height / layers_;
  squares_ = {across, many_deep ? std::max(1, static_cast<int>(std::lround(extent[1] / width))) : 1};
  for (std::size_t a = 0; a < 2; ++a) {
    lower_[a] = -0.5 * extent[a];
    spacing_[a] = extent[a] / squares_[a];
  }
  radius_ = cylinder_ ? 0.5 * geometry.diameter : 0.0;
  section_area_ = cylinder_ ? std::numbers::pi * radius_ * radius_ : extent[0] * extent[1];

  const auto nx = static_cast<std::size_t>(squares_[0]), ny = static_cast<std::size_t>(squares_[1]);
  struct Square {
    double area = 0.0;
    std::array<double, 2> centre{}, centroid{};
    int master = -1;  ///< index of the square this one is joined to, or itself
  };
  std::vector<Square> square(nx * ny);
  const auto edge = [&](std::size_t axis, std::size_t i) {
    return lower_[axis] + static_cast<double>(i) * spacing_[axis];
  };
  const double full = spacing_[0] * spacing_[1];
  const bool cut = cylinder_ && squares_[0] > 1;
  for (std::size_t iy = 0; iy < ny; ++iy)
    for (std::size_t ix = 0; ix < nx; ++ix) {
      Square& s = square[iy * nx + ix];
      const double x0 = edge(0, ix), x1 = edge(0, ix + 1), y0 = edge(1, iy), y1 = edge(1, iy + 1);
      s.centre = {0.5 * (x0 + x1), 0.5 * (y0 + y1)};
      s.centroid = s.centre;
      s.area = cut ? circle_rectangle_area(radius_, x0, x1, y0, y1) : (cylinder_ ? section_area_ : full);
      if (cut && s.area > 0.0 && s.area < full * (1.0 - 1e-12))
        s.centroid = {rectangle_moment(1, radius_, x0, x1, y0, y1) / s.area,
                      rectangle_moment(1, radius_, y0, y1, x0, x1) / s.area};
    }
  const auto neighbour = [&](std::size_t ix, std::size_t iy, std::size_t axis, int shift) -> int {
    int k[2] = {static_cast<int>(ix), static_cast<int>(iy)};
    k[axis] += shift;
    if (periodic_ && squares_[axis] > 1) k[axis] = (k[axis] + squares_[axis]) % squares_[axis];
    if (k[axis] < 0 || k[axis] >= squares_[axis]) return -1;
    return k[1] * squares_[0] + k[0];
  };
  /// Wetted part of the line across `axis` at the upper (shift 1) or lower side of a square.
  const auto wetted = [&](std::size_t ix, std::size_t iy, std::size_t axis, int shift) -> std::array<double, 2> {
    const std::size_t line = (axis == 0 ? ix : iy) + (shift > 0 ? 1 : 0), along = axis == 0 ? iy : ix;
    const double start = edge(1 - axis, along), end = edge(1 - axis, along + 1);
    return cut ? segment_inside(radius_, edge(axis, line), start, end) : std::array<double, 2>{start, end};
  };
  // Join small cut squares to the neighbour with the longest shared face.
  constexpr double smallest_share = 0.5;
  for (std::size_t q = 0; q < square.size(); ++q)
    if (square[q].area >= smallest_share * full || !cut) square[q].master = static_cast<int>(q);
  if (cut) {
    for (std::size_t iy = 0; iy < ny; ++iy)
      for (std::size_t ix = 0; ix < nx; ++ix) {
        Square& s = square[iy * nx + ix];
        if (s.master >= 0 || s.area <= 0.0) continue;
        double longest = 0.0;
        for (std::size_t axis : {std::size_t{0}, std::size_t{1}})
          for (int shift : {-1, 1}) {
            const int n = neighbour(ix, iy, axis, shift);
            if (n < 0 || square[static_cast<std::size_t>(n)].master != n) continue;
            const auto [start, end] = wetted(ix, iy, axis, shift);
            const double shared = end - start;
            if (shared > longest) {
              longest = shared;
              s.master = n;
            }
          }
      }
  }
  // Squares that still belong nowhere (outside the wall, or a corner sliver) go to the nearest cell.
  for (std::size_t q = 0; q < square.size(); ++q) {
    if (square[q].master >= 0) continue;
    double nearest = 1e300;
    for (std::size_t m = 0; m < square.size(); ++m) {
      if (square[m].master != static_cast<int>(m) || square[m].area < smallest_share * full) continue;
      const double d = std::hypot(square[m].centre[0] - square[q].centre[0], square[m].centre[1] - square[q].centre[1]);
      if (d < nearest) {
        nearest = d;
        square[q].master = static_cast<int>(m);
      }
    }
  }
  // Number the cells and add up joined areas. A cell's own square is at least half inside, so its centre is inside.
  std::vector<int> number(square.size(), -1);
  for (std::size_t q = 0; q < square.size(); ++q)
    if (square[q].master == static_cast<int>(q)) {
      number[q] = cells();
      area_.push_back(0.0);
      centre_.push_back(square[q].centre);
      centroid_.push_back({0.0, 0.0});
    }
  const auto count = area_.size();
  cell_of_square_.resize(square.size());
  for (std::size_t q = 0; q < square.size(); ++q) {
    cell_of_square_[q] = number[static_cast<std::size_t>(square[q].master)];
    const auto c = static_cast<std::size_t>(cell_of_square_[q]);
    area_[c] += square[q].area;
    for (std::size_t a = 0; a < 2; ++a) centroid_[c][a] += square[q].area * square[q].centroid[a];
  }
  for (std::size_t c = 0; c < count; ++c)
    for (double& coordinate : centroid_[c]) coordinate /= area_[c];
  // Faces between different cells whose own squares meet; a joined sliver keeps only its vertical connection.
  for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    face_of_[axis].assign(2 * count, -1);
    for (std::size_t iy = 0; iy < ny; ++iy)
      for (std::size_t ix = 0; ix < nx; ++ix) {
        const std::size_t q = iy * nx + ix;
        if (number[q] < 0) continue;
        const int n = neighbour(ix, iy, axis, 1);
        if (n < 0 || number[static_cast<std::size_t>(n)] < 0 || n == static_cast<int>(q)) continue;
        const int a = number[q], b = number[static_cast<std::size_t>(n)];
        const auto [start, end] = wetted(ix, iy, axis, 1);
        if (end <= start) continue;
        face_of_[axis][2 * static_cast<std::size_t>(a) + 1] = static_cast<int>(faces_[axis].size());
        face_of_[axis][2 * static_cast<std::size_t>(b)] = static_cast<int>(faces_[axis].size());
        faces_[axis].push_back({a, b, end - start, 0.5 * (start + end)});
      }
  }
}

}  // namespace slfb::fluid
