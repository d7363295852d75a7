#include "solver/coupling/void_fraction/share_table.hpp"

#include <algorithm>
#include <cmath>

namespace slfb::coupling {

ShareTable::ShareTable(const fluid::ColumnGrid& grid, double largest_reach) : grid_(grid) {
  for (std::size_t a = 0; a < 3; ++a) {
    Axis& axis = axis_[a];
    axis.origin = a == 2 ? 0.0 : grid.lower(a);
    axis.width = a == 2 ? grid.cell_height() : grid.spacing(a);
    axis.cells = a == 2 ? grid.layers() : grid.squares(a);
    axis.per_length = 1.0 / axis.width;
    axis.wraps = a != 2 && grid.periodic();
    // A diameter of n cells and a bit can reach into n + 2; the allowance is for round-off where it is a whole number.
    const double diameter = 2.0 * largest_reach;
    if (diameter > 0.0) stride_ *= static_cast<std::size_t>(diameter / axis.width * (1.0 + 1e-9)) + 2;
  }
  std::vector<int> squares_of_cell(static_cast<std::size_t>(grid.cells()), 0);
  for (int iy = 0; iy < grid.squares(1); ++iy)
    for (int ix = 0; ix < grid.squares(0); ++ix)
      ++squares_of_cell[static_cast<std::size_t>(grid.cell_of_square(ix, iy))];
  const auto alone = [&](int ix, int iy) {
    return ix < grid.squares(0) && iy < grid.squares(1) &&
           squares_of_cell[static_cast<std::size_t>(grid.cell_of_square(ix, iy))] == 1;
  };
  for (int iy = 0; iy < grid.squares(1); ++iy)
    for (int ix = 0; ix < grid.squares(0); ++ix)
      alone_with_next_.push_back(alone(ix, iy) && alone(ix + 1, iy) && alone(ix, iy + 1) && alone(ix + 1, iy + 1) ? 1
                                                                                                                  : 0);
}

void ShareTable::resize(std::size_t spheres) {
  cell_.resize(spheres * stride_);
  share_.resize(spheres * stride_);
  count_.resize(spheres);
}

CellBlock ShareTable::block_around(const std::array<double, 3>& x, double reach) const {
  CellBlock block{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Axis& axis = axis_[a];
    int first = static_cast<int>(std::floor((x[a] - reach - axis.origin) * axis.per_length));
    int last = static_cast<int>(std::floor((x[a] + reach - axis.origin) * axis.per_length));
    if (!axis.wraps) {
      first = std::clamp(first, 0, axis.cells - 1);
      last = std::clamp(last, 0, axis.cells - 1);
    }
    block.first[a] = first;
    block.cells[a] = last - first + 1;
  }
  return block;
}

void ShareTable::keep_occupied(std::size_t i, const CellBlock& block) {
  std::uint32_t* own_cells = cells(i);
  double* own_shares = shares(i);
  const auto within = [](const Axis& axis, int k) {
    return k >= 0 && k < axis.cells ? k : ((k % axis.cells) + axis.cells) % axis.cells;
  };
  int count = 0, part = 0;
  for (int ix = 0; ix < block.cells[0]; ++ix)
    for (int iy = 0; iy < block.cells[1]; ++iy) {
      const int bottom =
          lowest_cell(within(axis_[0], block.first[0] + ix), within(axis_[1], block.first[1] + iy), block);
      for (int iz = 0; iz < block.cells[2]; ++iz, ++part) {
        const double share = own_shares[part];
        if (share <= 0.0) continue;
        // Squares outside the round wall belong to cells inside it, so that a cell can come up again.
        const auto cell = static_cast<std::uint32_t>(bottom + iz);
        const auto m = std::find(own_cells, own_cells + count, cell) - own_cells;
        if (m == count) {
          own_cells[count] = cell;
          own_shares[count] = share;
          ++count;
        } else {
          own_shares[m] += share;
        }
      }
    }
  count_[i] = count;
}

}  // namespace slfb::coupling
