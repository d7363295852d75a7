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

std::size_t PointValues::home(const std::array<double, 3>& x) const {
  const auto index = [&](std::size_t a) {
    return static_cast<int>(std::floor((x[a] - grid_.lower(a)) / grid_.spacing(a)));
  };
  return cell(index(0), index(1), static_cast<int>(std::floor(x[2] / grid_.cell_height())));
}

std::array<std::array<double, 3>, 4> PointValues::gradient(const std::array<double, 3>& x,
                                                           const std::vector<CellValues>& cells) const {
  const auto layers = static_cast<std::size_t>(grid_.layers());
  const std::size_t here = home(x), k = here % layers;
  const int section = static_cast<int>(here / layers);
  const std::array<double, 8>& own = cells[here].value;
  std::array<std::array<double, 3>, 4> result{};
  const auto set = [&](std::size_t a, double width, const std::array<double, 8>* below,
                       const std::array<double, 8>* above, bool wall) {
    for (std::size_t f = 0; f < 4; ++f) {
      const auto on_face = [&](const std::array<double, 8>* beyond) {
        if (beyond != nullptr) return 0.5 * (own[f] + (*beyond)[f]);
        return wall && f > 0 ? 0.0 : own[f];
      };
      result[f][a] = (on_face(above) - on_face(below)) / width;
    }
  };
  for (std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    const auto neighbour = [&](std::size_t side) -> const std::array<double, 8>* {
      const int face = grid_.face_of(section, a, side);
      if (face < 0) return nullptr;
      const auto& f = grid_.faces(a)[static_cast<std::size_t>(face)];
      return &cells[static_cast<std::size_t>(side == 0 ? f.first : f.second) * layers + k].value;
    };
    // One cell across has no walls to be felt: the flow is plane.
    set(a, grid_.spacing(a), neighbour(0), neighbour(1), no_slip_ && grid_.squares(a) > 1);
  }
  set(2, grid_.cell_height(), k > 0 ? &cells[here - 1].value : nullptr,
      k + 1 < layers ? &cells[here + 1].value : nullptr, false);
  return result;
}

std::array<double, 4> PointValues::by_gradient(const std::array<double, 3>& x,
                                               const std::vector<CellValues>& cells) const {
  const auto slope = gradient(x, cells);
  const std::size_t here = home(x), layers = static_cast<std::size_t>(grid_.layers());
  const auto centre = grid_.centre(static_cast<int>(here / layers));
  std::array<double, 3> offset{x[0] - centre[0], x[1] - centre[1],
                               x[2] - (static_cast<double>(here % layers) + 0.5) * grid_.cell_height()};
  for (std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    const double period = grid_.squares(a) * grid_.spacing(a);
    if (grid_.periodic()) offset[a] -= period * std::nearbyint(offset[a] / period);
  }
  std::array<double, 4> result{};
  for (std::size_t f = 0; f < 4; ++f) {
    result[f] = cells[here].value[f];
    for (std::size_t a = 0; a < 3; ++a) result[f] += offset[a] * slope[f][a];
  }
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
