#include "solver/dem/cell_search.hpp"

#include <limits>
#include <tuple>

namespace slfb::dem {

const std::vector<std::uint32_t>& CellSearch::sort(const std::vector<Vec4>& position, double skin,
                                                   const std::array<double, 3>& period) {
  const std::size_t n = position.size();
  skin_ = skin;
  period_ = period;
  std::array<double, 3> lower{}, upper{};
  double largest_radius = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<double, 3> x{position[i].x, position[i].y, position[i].z};
    for (std::size_t a = 0; a < 3; ++a) {
      lower[a] = i == 0 ? x[a] : std::min(lower[a], x[a]);
      upper[a] = i == 0 ? x[a] : std::max(upper[a], x[a]);
    }
    largest_radius = std::max(largest_radius, position[i].w);
  }
  const double reach = 2.0 * largest_radius + skin;
  std::array<double, 3> extent{}, inverse{};
  // Without spheres there is no reach, and one cell does.
  double size = n > 0 ? reach : std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 3; ++a) {
    if (period[a] > 0.0) lower[a] = -0.5 * period[a];
    extent[a] = period[a] > 0.0 ? period[a] : upper[a] - lower[a];
  }
  // A few far spheres must not cost a table of empty cells.
  const auto count = [&](std::size_t a) { return std::max(1.0, std::floor(extent[a] / size)); };
  while (count(0) * count(1) * count(2) > 8.0 * static_cast<double>(n) + 64.0) size *= 1.5;
  for (std::size_t a = 0; a < 3; ++a) {
    cells_[a] = static_cast<int>(count(a));
    // Below three cells a periodic direction would visit a neighbour twice: use one cell there.
    if (period[a] > 0.0 && cells_[a] < 3) cells_[a] = 1;
    inverse[a] = extent[a] > 0.0 ? cells_[a] / extent[a] : 0.0;
  }
  const auto cell_coordinate = [&](std::size_t a, double value) {
    return std::clamp(static_cast<int>((value - lower[a]) * inverse[a]), 0, cells_[a] - 1);
  };

  const std::size_t cell_count =
      static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(cells_[2]);
  unsorted_cell_.resize(n);
  cell_start_.assign(cell_count + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    unsorted_cell_[i] = cell_index(cell_coordinate(0, position[i].x), cell_coordinate(1, position[i].y),
                                   cell_coordinate(2, position[i].z));
    ++cell_start_[unsorted_cell_[i] + 1];
  }
  for (std::size_t c = 0; c < cell_count; ++c) cell_start_[c + 1] += cell_start_[c];
  order_.resize(n);
  // Filled from the back, each start ends where its cell begins.
  for (std::size_t i = 0; i < n; ++i) order_[--cell_start_[unsorted_cell_[i] + 1]] = static_cast<std::uint32_t>(i);
  cell_start_.erase(cell_start_.begin());
  cell_start_.push_back(static_cast<std::uint32_t>(n));

  const auto key = [&](std::uint32_t i) { return std::tuple(position[i].x, position[i].y, position[i].z); };
  cell_of_.resize(n);
  for (std::size_t c = 0; c < cell_count; ++c) {
    const std::uint32_t first = cell_start_[c], last = cell_start_[c + 1];
    if (last - first > 1)
      std::sort(order_.begin() + first, order_.begin() + last,
                [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::uint32_t i = first; i < last; ++i) cell_of_[i] = static_cast<std::uint32_t>(c);
  }
  return order_;
}

}  // namespace slfb::dem
