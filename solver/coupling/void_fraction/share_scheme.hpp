#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "solver/coupling/void_fraction/share_table.hpp"
#include "solver/dem/particles.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::coupling {

/// Centres and radii of spheres [m].
struct Balls {
  const dem::VectorField& centre;
  const std::vector<double>& radius;
};

/// How the volume of a sphere is shared among the cells of the grid: a void-fraction scheme. Each is a type in a file
/// of its own and a line in schemes.cpp.
class ShareScheme {
 public:
  ShareScheme() = default;
  ShareScheme(const ShareScheme&) = delete;
  ShareScheme& operator=(const ShareScheme&) = delete;
  virtual ~ShareScheme() = default;

  /// How far from its centre a sphere can lie in other cells [m].
  [[nodiscard]] virtual double reach(double radius) const { return radius; }
  /// Fills the table, which has room for all spheres, with cells and shares that add up to one per sphere. Called once
  /// per update; the loop over the spheres is the scheme's own. \return layers from below that spheres reach into
  virtual std::size_t share_out(const Balls& balls, ShareTable& table, int threads) const = 0;
};

/// The scheme that a scene names, coupling.void_fraction, with its keys.
std::unique_ptr<ShareScheme> make_share_scheme(const Coupling& keys);

/// For share_out(): calls fill(first, last) for spheres first to last − 1, four at a time (the last may be fewer), on
/// all threads; it returns how many layers from below they reach into. \return the largest
template <class Fill>
std::size_t share_out_by_fours(std::size_t spheres, int threads, const Fill& fill) {
  int occupied = 0;
  const std::size_t groups = (spheres + 3) / 4;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : occupied)
  for (std::size_t group = 0; group < groups; ++group) {
    const std::size_t first = 4 * group, last = std::min(first + 4, spheres);
    occupied = std::max(occupied, static_cast<int>(fill(first, last)));
  }
  return static_cast<std::size_t>(occupied);
}

/// For such a fill: one sphere after the other. cut(block, centre, radius, parts) writes the parts of the volume that
/// lie in the cells of the block, z fastest; a sphere in a single cell is not cut.
template <class Scheme, class Cut>
int share_out_one_by_one(const Balls& balls, std::size_t first, std::size_t last, const Scheme& scheme,
                         ShareTable& table, const Cut& cut) {
  int occupied = 0;
  for (std::size_t i = first; i < last; ++i) {
    const std::array<double, 3> centre = balls.centre.at(i);
    const double radius = balls.radius[i];
    const CellBlock block = table.block_around(centre, scheme.reach(radius));
    if (block.size() == 1)
      table.shares(i)[0] = 1.0;
    else
      cut(block, centre, radius, table.shares(i));
    table.keep_occupied(i, block);
    occupied = std::max(occupied, block.first[2] + block.cells[2]);
  }
  return occupied;
}

}  // namespace slfb::coupling
