#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/support/vec3.hpp"

namespace slfb::dem {

/// Sorts spheres into a grid of cells, z slowest, and finds the pairs that are closer than a reach.
///
/// The order depends on the positions alone (ties by coordinates, not by number), so that everything summed in it is
/// the same however the spheres were numbered before. In this order the neighbours j > i of a sphere lie in five
/// contiguous stretches.
class CellSearch {
 public:
  /// Image of a periodic neighbour: (shift_x + 1) + 3 (shift_y + 1) + 9 (shift_z + 1) periods to add to its position.
  static constexpr std::uint8_t own_image = 13;

  /// Returns the sorted order: order[new] = old. `position`: centre and radius [m]; `period`: extent of a periodic box
  /// around the origin, 0 where the domain is not periodic [m]; `skin`: see for_pairs [m].
  const std::vector<std::uint32_t>& sort(const std::vector<Vec4>& position, double skin,
                                         const std::array<double, 3>& period);

  /// Calls visit(j, image) for each j > i with |x_j − x_i| < r_i + r_j + skin, j ascending. `position` is in sorted
  /// order.
  template <class Visit>
  void for_pairs(const std::vector<Vec4>& position, std::uint32_t i, Visit visit) const {
    const std::uint32_t cell = cell_of_[i];
    const std::array<int, 3> c{static_cast<int>(cell) % cells_[0], static_cast<int>(cell) / cells_[0] % cells_[1],
                               static_cast<int>(cell) / (cells_[0] * cells_[1])};
    for (std::size_t a = 0; a < 3; ++a)
      if (period_[a] > 0.0 && (c[a] == 0 || c[a] == cells_[a] - 1)) return for_pairs_at_face(position, i, c, visit);
    const Vec4 own = position[i];
    const double own_reach = own.w + skin_;
    const auto search = [&](std::uint32_t from, std::uint32_t to) {
      for (std::uint32_t j = from; j < to; ++j) {
        const double dx = position[j].x - own.x, dy = position[j].y - own.y, dz = position[j].z - own.z;
        const double reach = own_reach + position[j].w;
        if (dx * dx + dy * dy + dz * dz < reach * reach) visit(j, own_image);
      }
    };
    const int left = std::max(c[0] - 1, 0), right = std::min(c[0] + 1, cells_[0] - 1);
    const auto row = [&](int cy, int cz) {
      if (cy < 0 || cy >= cells_[1] || cz >= cells_[2]) return;
      search(cell_start_[cell_index(left, cy, cz)], cell_start_[cell_index(right, cy, cz) + 1]);
    };
    search(i + 1, cell_start_[cell_index(right, c[1], c[2]) + 1]);
    row(c[1] + 1, c[2]);
    for (int cy = c[1] - 1; cy <= c[1] + 1; ++cy) row(cy, c[2] + 1);
  }

 private:
  struct Found {
    std::uint32_t j;
    std::uint8_t image;
  };

  /// In a cell at a periodic face: all cells around, the nearest image of each sphere.
  template <class Visit>
  void for_pairs_at_face(const std::vector<Vec4>& position, std::uint32_t i, const std::array<int, 3>& c,
                         Visit visit) const {
    std::array<std::array<int, 3>, 3> around{};
    std::array<std::size_t, 3> count{};
    for (std::size_t a = 0; a < 3; ++a)
      for (int shift = -1; shift <= 1; ++shift) {
        int k = c[a] + shift;
        if (period_[a] > 0.0 && cells_[a] > 1) k = (k + cells_[a]) % cells_[a];
        if (k >= 0 && k < cells_[a]) around[a][count[a]++] = k;
      }
    const Vec4 own = position[i];
    thread_local std::vector<Found> found;
    found.clear();
    for (std::size_t z = 0; z < count[2]; ++z)
      for (std::size_t y = 0; y < count[1]; ++y)
        for (std::size_t x = 0; x < count[0]; ++x) {
          const std::uint32_t cell = cell_index(around[0][x], around[1][y], around[2][z]);
          for (std::uint32_t j = std::max(cell_start_[cell], i + 1); j < cell_start_[cell + 1]; ++j) {
            std::array<double, 3> d{position[j].x - own.x, position[j].y - own.y, position[j].z - own.z};
            int image = own_image, weight = 1;
            for (std::size_t a = 0; a < 3; ++a, weight *= 3) {
              if (!(period_[a] > 0.0)) continue;
              const double periods = -std::nearbyint(d[a] / period_[a]);
              d[a] += periods * period_[a];
              image += weight * static_cast<int>(periods);
            }
            const double reach = own.w + position[j].w + skin_;
            if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach)
              found.push_back({j, static_cast<std::uint8_t>(image)});
          }
        }
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.j < b.j; });
    for (const Found& pair : found) visit(pair.j, pair.image);
  }

  [[nodiscard]] std::uint32_t cell_index(int cx, int cy, int cz) const {
    return static_cast<std::uint32_t>((cz * cells_[1] + cy) * cells_[0] + cx);
  }

  double skin_ = 0.0;
  std::array<double, 3> period_{};
  std::array<int, 3> cells_{};
  std::vector<std::uint32_t> cell_start_, cell_of_, order_, unsorted_cell_;
};

}  // namespace slfb::dem
