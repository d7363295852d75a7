#include "solver/coupling/point_values.hpp"

#include <algorithm>
#include <cmath>

namespace slfb::coupling {

PointValues::PointValues(const fluid::ColumnGrid& grid, Interpolation scheme, bool no_slip)
    : grid_(grid), scheme_(scheme), no_slip_(no_slip) {}

/// Cell at lattice coordinates; outside the column the nearest one, or the periodic image.
std::size_t PointValues::cell(int ix, int iy, int layer) const {
  const auto within = [&](int k, std::size_t axis) {
    const int squares = grid_.squares(axis);
    return grid_.periodic() ? ((k % squares) + squares) % squares : std::clamp(k, 0, squares - 1);
  };
  const int section = grid_.cell_of_square(within(ix, 0), within(iy, 1));
  return static_cast<std::size_t>(section * grid_.layers() + std::clamp(layer, 0, grid_.layers() - 1));
}

std::array<double, 4> PointValues::at(const std::array<double, 3>& x, const std::vector<CellValues>& cells) const {
  return scheme_ == Interpolation::gradient ? by_gradient(x, cells) : trilinear(x, cells);
}

std::array<double, 4> PointValues::by_gradient(const std::array<double, 3>& x,
                                               const std::vector<CellValues>& cells) const {
  const auto index = [&](std::size_t a) {
    return static_cast<int>(std::floor((x[a] - grid_.lower(a)) / grid_.spacing(a)));
  };
  const int layer = static_cast<int>(std::floor(x[2] / grid_.cell_height()));
  const std::size_t home = cell(index(0), index(1), layer);
  const auto layers = static_cast<std::size_t>(grid_.layers());
  const int section = static_cast<int>(home / layers);
  const std::size_t k = home % layers;
  const std::array<double, 8>& own = cells[home].value;
  std::array<double, 4> result{own[0], own[1], own[2], own[3]};

  const auto add = [&](double offset, double width, const std::array<double, 8>* below, bool wall_below,
                       const std::array<double, 8>* above, bool wall_above) {
    for (std::size_t f = 0; f < 4; ++f) {
      const auto on_face = [&](const std::array<double, 8>* beyond, bool wall) {
        if (beyond != nullptr) return 0.5 * (own[f] + (*beyond)[f]);
        return wall && f > 0 ? 0.0 : own[f];
      };
      result[f] += offset * (on_face(above, wall_above) - on_face(below, wall_below)) / width;
    }
  };
  for (std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    const auto neighbour = [&](std::size_t side) -> const std::array<double, 8>* {
      const int face = grid_.face_of(section, a, side);
      if (face < 0) return nullptr;
      const auto& f = grid_.faces(a)[static_cast<std::size_t>(face)];
      return &cells[static_cast<std::size_t>(side == 0 ? f.first : f.second) * layers + k].value;
    };
    const double width = grid_.spacing(a);
    double offset = x[a] - grid_.centre(section)[a];
    if (grid_.periodic()) offset -= grid_.squares(a) * width * std::nearbyint(offset / (grid_.squares(a) * width));
    // One cell across has no walls to be felt: the flow is plane.
    const bool wall = no_slip_ && grid_.squares(a) > 1;
    add(offset, width, neighbour(0), wall, neighbour(1), wall);
  }
  const double height = grid_.cell_height();
  add(x[2] - (static_cast<double>(k) + 0.5) * height, height, k > 0 ? &cells[home - 1].value : nullptr, false,
      k + 1 < layers ? &cells[home + 1].value : nullptr, false);
  return result;
}

std::array<double, 4> PointValues::trilinear(const std::array<double, 3>& x,
                                             const std::vector<CellValues>& cells) const {
  std::array<int, 3> first{};
  std::array<double, 3> part{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double width = a == 2 ? grid_.cell_height() : grid_.spacing(a), origin = a == 2 ? 0.0 : grid_.lower(a);
    const double s = (x[a] - origin) / width - 0.5;
    first[a] = static_cast<int>(std::floor(s));
    part[a] = s - first[a];
  }
  std::array<double, 4> result{};
  for (int corner = 0; corner < 8; ++corner) {
    const std::array<int, 3> step{corner & 1, corner >> 1 & 1, corner >> 2};
    double weight = 1.0;
    for (std::size_t a = 0; a < 3; ++a) weight *= step[a] == 1 ? part[a] : 1.0 - part[a];
    const auto& value = cells[cell(first[0] + step[0], first[1] + step[1], first[2] + step[2])].value;
    for (std::size_t f = 0; f < 4; ++f) result[f] += weight * value[f];
  }
  return result;
}

}  // namespace slfb::coupling
