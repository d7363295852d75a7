#include "solver/coupling/void_fraction/exact_overlap.hpp"

#include <algorithm>

#include "solver/coupling/void_fraction/sphere_overlap.hpp"

namespace slfb::coupling {
namespace {

using Whole = int __attribute__((vector_size(16)));       ///< one per ball
using Mask = long long __attribute__((vector_size(32)));  ///< what comparing packs gives

/// Whole numbers not above four numbers.
Whole floor_of(Pack x) {
  const Whole towards_zero = __builtin_convertvector(x, Whole);
  return towards_zero + __builtin_convertvector(x < __builtin_convertvector(towards_zero, Pack), Whole);
}

void cut_sphere(const ShareTable& table, const CellBlock& block, const std::array<double, 3>& x, double r,
                double* parts) {
  const double per_radius = 1.0 / r;
  const auto planes = [&](std::size_t a) -> PlaneRow {
    const ShareTable::Axis& axis = table.axis(a);
    return {(axis.origin + (block.first[a] + 1) * axis.width - x[a]) * per_radius, axis.width * per_radius,
            block.cells[a] - 1};
  };
  unit_ball_parts(planes(0), planes(1), planes(2), parts);
}

/// Cells and shares of spheres `first` to `first` + 3; returns the layer up to which they reach, or 0, having done
/// nothing, where one of them lies in more than two cells along an axis.
int cut_four_spheres(const Balls& balls, std::size_t first, ShareTable& table) {
  const std::array<const double*, 3> centre{&balls.centre.x[first], &balls.centre.y[first], &balls.centre.z[first]};
  const Pack r = load(&balls.radius[first]), per_radius = 1.0 / r, beyond = Pack{} + 1.0;
  std::array<Whole, 3> lowest, further;  // cells that the spheres begin in; 1 where they reach into the next
  std::array<Pack, 3> planes;
  for (std::size_t a = 0; a < 3; ++a) {
    const ShareTable::Axis& axis = table.axis(a);
    const Pack x = load(centre[a]);
    Whole low = floor_of((x - r - axis.origin) * axis.per_length),
          high = floor_of((x + r - axis.origin) * axis.per_length);
    if (!axis.wraps) {  // as in ShareTable::block_around
      const Whole none{}, top = none + (axis.cells - 1);
      low = low < 0 ? none : low > top ? top : low;
      high = high < 0 ? none : high > top ? top : high;
    }
    lowest[a] = low;
    further[a] = high - low;
    const auto cut = __builtin_convertvector(high > low, Mask);
    const Pack plane = axis.origin + __builtin_convertvector(low + 1, Pack) * axis.width;
    planes[a] = cut ? (plane - x) * per_radius : beyond;
    const Whole many = further[a] > 1;
    if (many[0] | many[1] | many[2] | many[3]) return 0;
  }
  std::array<Pack, 8> octants;
  unit_ball_octants(planes, octants);
  int top = 0;
  for (int lane = 0; lane < 4; ++lane) {
    const std::size_t i = first + static_cast<std::size_t>(lane);
    const CellBlock block{{lowest[0][lane], lowest[1][lane], lowest[2][lane]},
                          {further[0][lane] + 1, further[1][lane] + 1, further[2][lane] + 1}};
    top = std::max(top, block.first[2] + block.cells[2]);
    double* shares = table.shares(i);
    if (!table.has_a_cell_per_square(block)) {
      double* part = shares;
      for (int ix = 0; ix < block.cells[0]; ++ix)
        for (int iy = 0; iy < block.cells[1]; ++iy)
          for (int iz = 0; iz < block.cells[2]; ++iz)
            *part++ = octants[static_cast<std::size_t>(4 * ix + 2 * iy + iz)][lane];
      table.keep_occupied(i, block);
      continue;
    }
    std::uint32_t* cells = table.cells(i);
    int count = 0;
    for (int ix = 0; ix < 2; ++ix)
      for (int iy = 0; iy < 2; ++iy) {
        const int bottom = table.lowest_cell(block.first[0] + ix, block.first[1] + iy, block);
        for (int iz = 0; iz < 2; ++iz) {
          const double share = octants[static_cast<std::size_t>(4 * ix + 2 * iy + iz)][lane];
          // Written always, kept if anything is there: no branch that the processor would have to guess.
          cells[count] = static_cast<std::uint32_t>(bottom + iz);
          shares[count] = share;
          count += share > 0.0 ? 1 : 0;
        }
      }
    table.set_count(i, count);
  }
  return top;
}

}  // namespace

std::size_t ExactOverlap::share_out(const Balls& balls, ShareTable& table, int threads) const {
  const auto cut = [&](const CellBlock& block, const std::array<double, 3>& x, double r, double* parts) {
    cut_sphere(table, block, x, r, parts);
  };
  return share_out_by_fours(balls.radius.size(), threads, [&](std::size_t first, std::size_t last) {
    const int top = last == first + 4 ? cut_four_spheres(balls, first, table) : 0;
    return top > 0 ? top : share_out_one_by_one(balls, first, last, *this, table, cut);
  });
}

}  // namespace slfb::coupling
