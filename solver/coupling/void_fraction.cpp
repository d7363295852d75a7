#include "solver/coupling/void_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/coupling/sphere_overlap.hpp"

namespace slfb::coupling {
namespace {

using Whole = int __attribute__((vector_size(16)));       ///< one per ball
using Mask = long long __attribute__((vector_size(32)));  ///< what comparing packs gives

/// Whole numbers not above four numbers.
Whole floor_of(Pack x) {
  const Whole towards_zero = __builtin_convertvector(x, Whole);
  return towards_zero + __builtin_convertvector(x < __builtin_convertvector(towards_zero, Pack), Whole);
}

}  // namespace

VolumeShares::VolumeShares(VoidFractionScheme scheme, int meshing_pieces, const fluid::ColumnGrid& grid,
                           double largest_radius)
    : scheme_(scheme), grid_(grid), largest_radius_(largest_radius) {
  for (std::size_t a = 0; a < 3; ++a) {
    Axis& axis = axis_[a];
    axis.origin = a == 2 ? 0.0 : grid.lower(a);
    axis.width = a == 2 ? grid.cell_height() : grid.spacing(a);
    axis.cells = a == 2 ? grid.layers() : grid.squares(a);
    axis.per_length = 1.0 / axis.width;
    axis.wraps = a != 2 && grid.periodic();
    // A diameter of n cells and a bit can reach into n + 2; the allowance is for round-off where it is a whole number.
    const double diameter = scheme == VoidFractionScheme::centroid ? 0.0 : 2.0 * largest_radius;
    if (diameter > 0.0) stride_ *= static_cast<std::size_t>(diameter / axis.width * (1.0 + 1e-9)) + 2;
  }
  if (scheme == VoidFractionScheme::particle_meshing) pieces_ = meshing_template(meshing_pieces);
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

/// No two squares of a block of at most two by two belong to one cell, and none lies across a side of the grid.
bool VolumeShares::has_a_cell_per_square(const Block& block) const {
  const auto [x, y, z] = block.first;
  return x >= 0 && x < axis_[0].cells && y >= 0 && y < axis_[1].cells &&
         alone_with_next_[static_cast<std::size_t>(y * axis_[0].cells + x)] != 0;
}

std::vector<std::array<double, 3>> VolumeShares::meshing_template(int pieces) {
  // Shells about as thick as a piece is wide; each holds pieces in proportion to its volume.
  const int shells = std::max(1, static_cast<int>(std::lround(std::cbrt(pieces * 3.0 / (4.0 * std::numbers::pi)))));
  std::vector<std::array<double, 3>> centroids;
  int placed = 0;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int s = 1; s <= shells; ++s) {
    const int upto =
        s == shells ? pieces : static_cast<int>(std::lround(pieces * std::pow(static_cast<double>(s) / shells, 3)));
    const int count = upto - placed;
    const double inner = std::cbrt(static_cast<double>(placed) / pieces),
                 outer = std::cbrt(static_cast<double>(upto) / pieces);
    // Radius of gyration of the shell, so that the second moment of the ball is kept; the innermost single piece is the
    // centre.
    const double radius =
        count == 1 && placed == 0
            ? 0.0
            : std::sqrt(0.6 * (std::pow(outer, 5) - std::pow(inner, 5)) / (std::pow(outer, 3) - std::pow(inner, 3)));
    for (int k = 0; k < count; ++k) {
      const double z = count == 1 ? 0.0 : 1.0 - (2.0 * k + 1.0) / count;
      const double ring = std::sqrt(1.0 - z * z), angle = golden_angle * k;
      centroids.push_back({radius * ring * std::cos(angle), radius * ring * std::sin(angle), radius * z});
    }
    placed = upto;
  }
  return centroids;
}

VolumeShares::Block VolumeShares::block_around(const std::array<double, 3>& x, double reach) const {
  Block block{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Axis& axis = axis_[a];
    int first = static_cast<int>(std::floor((x[a] - reach - axis.origin) * axis.per_length));
    int last = static_cast<int>(std::floor((x[a] + reach - axis.origin) * axis.per_length));
    // Nothing is cut outside the grid: what presses into a wall stays in the last cell.
    if (!axis.wraps) {
      first = std::clamp(first, 0, axis.cells - 1);
      last = std::clamp(last, 0, axis.cells - 1);
    }
    block.first[a] = first;
    block.cells[a] = last - first + 1;
  }
  return block;
}

void VolumeShares::mesh_particle(const Block& block, const std::array<double, 3>& x, double r, double* parts) const {
  std::array<double, 3> start{}, scale{};
  for (std::size_t a = 0; a < 3; ++a) {
    start[a] = (x[a] - axis_[a].origin) * axis_[a].per_length - block.first[a];
    scale[a] = r * axis_[a].per_length;
  }
  const auto cell = [&](const std::array<double, 3>& piece, std::size_t a) {
    return std::clamp(static_cast<int>(std::floor(start[a] + scale[a] * piece[a])), 0, block.cells[a] - 1);
  };
  std::fill_n(parts, block.size(), 0.0);
  for (const auto& piece : pieces_)
    parts[(cell(piece, 0) * block.cells[1] + cell(piece, 1)) * block.cells[2] + cell(piece, 2)] += 1.0;
  for (int n = 0; n < block.size(); ++n) parts[n] /= static_cast<double>(pieces_.size());
}

void VolumeShares::cut_sphere(const Block& block, const std::array<double, 3>& x, double r, double* parts) const {
  const double per_radius = 1.0 / r;
  const auto planes = [&](std::size_t a) -> PlaneRow {
    const Axis& axis = axis_[a];
    return {(axis.origin + (block.first[a] + 1) * axis.width - x[a]) * per_radius, axis.width * per_radius,
            block.cells[a] - 1};
  };
  unit_ball_parts(planes(0), planes(1), planes(2), parts);
}

void VolumeShares::cut_one_sphere(const Block& block, const std::array<double, 3>& x, double r, double* parts) const {
  if (block.size() == 1)
    parts[0] = 1.0;
  else if (scheme_ == VoidFractionScheme::particle_meshing)
    mesh_particle(block, x, r, parts);
  else
    cut_sphere(block, x, r, parts);
}

int VolumeShares::cut_four_spheres(const dem::VectorField& centres, const std::vector<double>& radius,
                                   std::size_t first) {
  const std::array<const double*, 3> centre{&centres.x[first], &centres.y[first], &centres.z[first]};
  const Pack r = load(&radius[first]), per_radius = 1.0 / r, beyond = Pack{} + 1.0;
  std::array<Whole, 3> lowest, further;  // cells that the spheres begin in; 1 where they reach into the next
  std::array<Pack, 3> planes;
  for (std::size_t a = 0; a < 3; ++a) {
    const Axis& axis = axis_[a];
    const Pack x = load(centre[a]);
    Whole low = floor_of((x - r - axis.origin) * axis.per_length),
          high = floor_of((x + r - axis.origin) * axis.per_length);
    if (!axis.wraps) {  // as in block_around
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
    const Block block{{lowest[0][lane], lowest[1][lane], lowest[2][lane]},
                      {further[0][lane] + 1, further[1][lane] + 1, further[2][lane] + 1}};
    top = std::max(top, block.first[2] + block.cells[2]);
    double* shares = &share_[i * stride_];
    if (!has_a_cell_per_square(block)) {
      double* part = shares;
      for (int ix = 0; ix < block.cells[0]; ++ix)
        for (int iy = 0; iy < block.cells[1]; ++iy)
          for (int iz = 0; iz < block.cells[2]; ++iz)
            *part++ = octants[static_cast<std::size_t>(4 * ix + 2 * iy + iz)][lane];
      keep_occupied(i, block);
      continue;
    }
    std::uint32_t* cells = &cell_[i * stride_];
    int count = 0;
    for (int ix = 0; ix < 2; ++ix)
      for (int iy = 0; iy < 2; ++iy) {
        const int bottom =
            grid_.cell_of_square(block.first[0] + ix, block.first[1] + iy) * grid_.layers() + block.first[2];
        for (int iz = 0; iz < 2; ++iz) {
          const double share = octants[static_cast<std::size_t>(4 * ix + 2 * iy + iz)][lane];
          // Written always, kept if anything is there: no branch that the processor would have to guess.
          cells[count] = static_cast<std::uint32_t>(bottom + iz);
          shares[count] = share;
          count += share > 0.0 ? 1 : 0;
        }
      }
    count_[i] = count;
  }
  return top;
}

void VolumeShares::keep_occupied(std::size_t i, const Block& block) {
  std::uint32_t* cells = &cell_[i * stride_];
  double* shares = &share_[i * stride_];
  const auto within = [](const Axis& axis, int k) {
    return k >= 0 && k < axis.cells ? k : ((k % axis.cells) + axis.cells) % axis.cells;
  };
  int count = 0, part = 0;
  for (int ix = 0; ix < block.cells[0]; ++ix)
    for (int iy = 0; iy < block.cells[1]; ++iy) {
      const int column =
          grid_.cell_of_square(within(axis_[0], block.first[0] + ix), within(axis_[1], block.first[1] + iy));
      const int bottom = column * grid_.layers() + block.first[2];
      for (int iz = 0; iz < block.cells[2]; ++iz, ++part) {
        const double share = shares[part];
        if (share <= 0.0) continue;
        // Squares outside the round wall belong to cells inside it, so that a cell can come up again.
        const auto cell = static_cast<std::uint32_t>(bottom + iz);
        const auto m = std::find(cells, cells + count, cell) - cells;
        if (m == count) {
          cells[count] = cell;
          shares[count] = share;
          ++count;
        } else {
          shares[m] += share;
        }
      }
    }
  count_[i] = count;
}

void VolumeShares::update(const dem::VectorField& centres, const std::vector<double>& radius, int threads) {
  const std::size_t n = radius.size();
  if (n > 0 && *std::max_element(radius.begin(), radius.end()) > largest_radius_)
    throw std::invalid_argument("void fraction: a sphere is larger than the largest of the scene's species");
  cell_.resize(n * stride_);
  share_.resize(n * stride_);
  count_.resize(n);
  int occupied = 0;
  const std::size_t groups = (n + 3) / 4;
  const bool exact = scheme_ == VoidFractionScheme::exact_overlap;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : occupied)
  for (std::size_t group = 0; group < groups; ++group) {
    const std::size_t first = 4 * group, last = std::min(first + 4, n);
    int top = exact && last == first + 4 ? cut_four_spheres(centres, radius, first) : 0;
    for (std::size_t i = first; top == 0 && i < last; ++i) {
      const Block block = block_around(centres.at(i), scheme_ == VoidFractionScheme::centroid ? 0.0 : radius[i]);
      cut_one_sphere(block, centres.at(i), radius[i], &share_[i * stride_]);
      keep_occupied(i, block);
      occupied = std::max(occupied, block.first[2] + block.cells[2]);
    }
    occupied = std::max(occupied, top);
  }
  occupied_layers_ = static_cast<std::size_t>(occupied);
}

}  // namespace slfb::coupling
