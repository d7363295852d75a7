#include "solver/fluid/column_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slfb::fluid {
namespace {

/// Area of the circle's part with x <= a and y <= b.
double quadrant_area(double r, double a, double b) {
  if (a <= -r || b <= -r) return 0.0;
  a = std::min(a, r);
  b = std::min(b, r);
  // ∫ over x from −r to a of the chord below b. Antiderivative of √(r² − x²).
  const auto primitive = [r](double x) {
    const double c = std::clamp(x / r, -1.0, 1.0);
    return 0.5 * r * r * (c * std::sqrt(std::max(0.0, 1.0 - c * c)) + std::asin(c));
  };
  // Where |x| > x_b the chord's upper end √(r² − x²) lies below |b|.
  const double x_b = std::sqrt(std::max(0.0, r * r - b * b));
  const auto between = [&](double x0, double x1) { return x1 > x0 ? primitive(x1) - primitive(x0) : 0.0; };
  const double outer = between(-r, std::min(a, -x_b)) + between(x_b, a);
  const double inner_width = std::max(0.0, std::min(a, x_b) + x_b);
  const double inner = a > -x_b ? between(-x_b, std::min(a, x_b)) + b * inner_width : 0.0;
  return b >= 0.0 ? 2.0 * outer + inner : inner;
}

/// Length of the part of the segment y = const from x0 to x1 inside the circle.
double segment_inside(double r, double y, double x0, double x1) {
  if (std::abs(y) >= r) return 0.0;
  const double half = std::sqrt(r * r - y * y);
  return std::max(0.0, std::min(x1, half) - std::max(x0, -half));
}

/// Length of the circle inside the rectangle.
double arc_inside(double r, double x0, double x1, double y0, double y1) {
  std::vector<double> cuts{-std::numbers::pi, std::numbers::pi};
  for (double x : {x0, x1})
    if (std::abs(x) < r) cuts.insert(cuts.end(), {std::acos(x / r), -std::acos(x / r)});
  for (double y : {y0, y1})
    if (std::abs(y) < r) {
      const double angle = std::asin(y / r);
      cuts.push_back(angle);
      cuts.push_back(angle >= 0.0 ? std::numbers::pi - angle : -std::numbers::pi - angle);
    }
  std::sort(cuts.begin(), cuts.end());
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
    const double x = r * std::cos(middle), y = r * std::sin(middle);
    if (x > x0 && x < x1 && y > y0 && y < y1) length += r * (cuts[k + 1] - cuts[k]);
  }
  return length;
}

}  // namespace

double circle_rectangle_area(double radius, double x0, double x1, double y0, double y1) {
  return quadrant_area(radius, x1, y1) - quadrant_area(radius, x0, y1) - quadrant_area(radius, x1, y0) +
         quadrant_area(radius, x0, y0);
}

bool ColumnGrid::square_inside(int ix, int iy) const {
  if (!cylinder_) return true;
  return std::hypot(lower_[0] + (ix + 0.5) * spacing_[0], lower_[1] + (iy + 0.5) * spacing_[1]) < radius_;
}

ColumnGrid::ColumnGrid(const Scene& scene) {
  const Geometry& geometry = scene.geometry;
  cylinder_ = geometry.shape == Shape::cylinder;
  periodic_ = !cylinder_ && scene.fluid.wall == LateralBoundary::periodic;
  const int across = scene.fluid.tier == FluidTier::three_dimensional ? scene.fluid.cells_across : 1;
  const std::array<double, 2> extent =
      cylinder_ ? std::array<double, 2>{geometry.diameter, geometry.diameter} : geometry.width;
  width_ = extent[0] / across;
  layers_ = std::max(1, static_cast<int>(std::lround(geometry.height / scene.fluid.cell_height)));
  height_ = geometry.height / layers_;
  squares_ = {across, std::max(1, static_cast<int>(std::lround(extent[1] / width_)))};
  if (scene.fluid.tier != FluidTier::three_dimensional) squares_[1] = 1;
  for (std::size_t a = 0; a < 2; ++a) {
    lower_[a] = -0.5 * extent[a];
    spacing_[a] = extent[a] / squares_[a];
  }
  radius_ = 0.5 * geometry.diameter;
  section_area_ = cylinder_ ? std::numbers::pi * radius_ * radius_ : extent[0] * extent[1];

  const auto nx = static_cast<std::size_t>(squares_[0]), ny = static_cast<std::size_t>(squares_[1]);
  struct Square {
    double area = 0.0, arc = 0.0, centroid_x = 0.0, centroid_y = 0.0;
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
      s.centroid_x = 0.5 * (x0 + x1);
      s.centroid_y = 0.5 * (y0 + y1);
      s.area = cut ? circle_rectangle_area(radius_, x0, x1, y0, y1) : (cylinder_ ? section_area_ : full);
      if (cut) {
        s.arc = arc_inside(radius_, x0, x1, y0, y1);
        if (s.arc > 0.0 && s.area > 0.0) {
          // First moments by slices across x, fine enough for a wall distance.
          constexpr int slices = 200;
          double mx = 0.0, my = 0.0, sum = 0.0;
          for (int k = 0; k < slices; ++k) {
            const double x = x0 + (k + 0.5) * (x1 - x0) / slices;
            if (std::abs(x) >= radius_) continue;
            const double half = std::sqrt(radius_ * radius_ - x * x);
            const double bottom = std::max(y0, -half), top = std::min(y1, half);
            if (top <= bottom) continue;
            sum += top - bottom;
            mx += x * (top - bottom);
            my += 0.5 * (top * top - bottom * bottom);
          }
          if (sum > 0.0) {
            s.centroid_x = mx / sum;
            s.centroid_y = my / sum;
          }
        }
      }
    }
  const auto neighbour = [&](std::size_t ix, std::size_t iy, std::size_t axis, int shift) -> int {
    int k[2] = {static_cast<int>(ix), static_cast<int>(iy)};
    k[axis] += shift;
    if (periodic_ && squares_[axis] > 1) k[axis] = (k[axis] + squares_[axis]) % squares_[axis];
    if (k[axis] < 0 || k[axis] >= squares_[axis]) return -1;
    return k[1] * squares_[0] + k[0];
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
            const std::size_t line = (axis == 0 ? ix : iy) + (shift > 0 ? 1 : 0);
            const double shared = axis == 0 ? segment_inside(radius_, edge(0, line), edge(1, iy), edge(1, iy + 1))
                                            : segment_inside(radius_, edge(1, line), edge(0, ix), edge(0, ix + 1));
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
      const double d =
          std::hypot(square[m].centroid_x - square[q].centroid_x, square[m].centroid_y - square[q].centroid_y);
      if (d < nearest) {
        nearest = d;
        square[q].master = static_cast<int>(m);
      }
    }
  }
  // Number the cells; add up joined areas, walls and centroids.
  std::vector<int> number(square.size(), -1);
  for (std::size_t q = 0; q < square.size(); ++q)
    if (square[q].master == static_cast<int>(q)) {
      number[q] = cells();
      area_.push_back(0.0);
    }
  const auto count = area_.size();
  wall_length_.assign(count, 0.0);
  wall_distance_.assign(count, 0.0);
  std::vector<double> centroid_x(count, 0.0), centroid_y(count, 0.0);
  cell_of_square_.resize(square.size());
  for (std::size_t q = 0; q < square.size(); ++q) {
    const int cell = number[static_cast<std::size_t>(square[q].master)];
    cell_of_square_[q] = cell;
    const auto c = static_cast<std::size_t>(cell);
    area_[c] += square[q].area;
    wall_length_[c] += square[q].arc;
    centroid_x[c] += square[q].area * square[q].centroid_x;
    centroid_y[c] += square[q].area * square[q].centroid_y;
  }
  for (std::size_t c = 0; c < count; ++c) {
    centroid_x[c] /= area_[c];
    centroid_y[c] /= area_[c];
    if (cut) wall_distance_[c] = radius_ - std::hypot(centroid_x[c], centroid_y[c]);
  }
  // Faces between different cells whose own squares meet; a joined sliver keeps only its vertical connection.
  for (std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    face_of_[axis].assign(2 * count, -1);
    for (std::size_t iy = 0; iy < ny; ++iy)
      for (std::size_t ix = 0; ix < nx; ++ix) {
        const std::size_t q = iy * nx + ix;
        if (number[q] < 0) continue;
        const int n = neighbour(ix, iy, axis, 1);
        const bool wall = n < 0;
        if (!wall && number[static_cast<std::size_t>(n)] >= 0 && n != static_cast<int>(q)) {
          const int a = number[q], b = number[static_cast<std::size_t>(n)];
          const std::size_t line = (axis == 0 ? ix : iy) + 1;
          const double length =
              !cut ? spacing_[1 - axis]
                   : (axis == 0 ? segment_inside(radius_, edge(0, line), edge(1, iy), edge(1, iy + 1))
                                : segment_inside(radius_, edge(1, line), edge(0, ix), edge(0, ix + 1)));
          if (length > 0.0) {
            face_of_[axis][2 * static_cast<std::size_t>(a) + 1] = static_cast<int>(faces_[axis].size());
            face_of_[axis][2 * static_cast<std::size_t>(b)] = static_cast<int>(faces_[axis].size());
            faces_[axis].push_back({a, b, length, spacing_[axis]});
          }
        }
        if (!cylinder_ && !periodic_ && scene.fluid.tier == FluidTier::three_dimensional) {
          // Box walls: full length, half a cell away.
          const auto c = static_cast<std::size_t>(number[q]);
          for (int shift : {-1, 1})
            if (neighbour(ix, iy, axis, shift) < 0) {
              wall_length_[c] += spacing_[1 - axis];
              wall_distance_[c] = 0.5 * spacing_[axis];
            }
        }
      }
  }
}

}  // namespace slfb::fluid
