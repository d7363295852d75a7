#include "solver/coupling/void_fraction/particle_meshing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace slfb::coupling {

std::vector<std::array<double, 3>> meshing_template(int pieces) {
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

namespace {

/// How many pieces lie in each of the eight octants that one plane per axis makes, first axis · 4 + second · 2 + third.
/// Only the first `Axes` axes have a plane. Sums of comparisons, so that vector units do it.
/// \param start, scale where the centre lies and how long the radius is, measured so that the plane lies at 1
template <int Axes>
std::array<std::int64_t, 8> count_octants(const std::array<const double*, 3>& pieces, std::size_t count,
                                          const std::array<double, 3>& start, const std::array<double, 3>& scale) {
  std::int64_t a = 0, b = 0, c = 0, ab = 0, ac = 0, bc = 0, abc = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const std::int64_t beyond_a = start[0] + scale[0] * pieces[0][p] >= 1.0;
    a += beyond_a;
    if constexpr (Axes > 1) {
      const std::int64_t beyond_b = start[1] + scale[1] * pieces[1][p] >= 1.0;
      b += beyond_b;
      ab += beyond_a & beyond_b;
      if constexpr (Axes > 2) {
        const std::int64_t beyond_c = start[2] + scale[2] * pieces[2][p] >= 1.0;
        c += beyond_c;
        ac += beyond_a & beyond_c;
        bc += beyond_b & beyond_c;
        abc += beyond_a & beyond_b & beyond_c;
      }
    }
  }
  const auto all = static_cast<std::int64_t>(count);
  return {all - a - b - c + ab + ac + bc - abc,
          c - ac - bc + abc,
          b - ab - bc + abc,
          bc - abc,
          a - ab - ac + abc,
          ac - abc,
          ab - abc,
          abc};
}

}  // namespace

ParticleMeshing::ParticleMeshing(int pieces) {
  for (const auto& centroid : meshing_template(pieces))
    for (std::size_t a = 0; a < 3; ++a) centroids_[a].push_back(centroid[a]);
}

std::size_t ParticleMeshing::share_out(const Balls& balls, ShareTable& table, int threads) const {
  const std::size_t pieces = centroids_[0].size();
  const auto count_pieces = [&](const CellBlock& block, const std::array<double, 3>& x, double r, double* parts) {
    std::array<double, 3> start{}, scale{};
    for (std::size_t a = 0; a < 3; ++a) {
      const ShareTable::Axis& axis = table.axis(a);
      start[a] = (x[a] - axis.origin) * axis.per_length - block.first[a];
      scale[a] = r * axis.per_length;
    }
    std::fill_n(parts, block.size(), 0.0);
    if (*std::max_element(block.cells.begin(), block.cells.end()) <= 2) {
      // The usual block: at most one plane of the grid crosses the sphere along each axis.
      std::array<const double*, 3> along{};
      std::array<double, 3> crossed_start{}, crossed_scale{};
      std::array<int, 3> step{};  // from a cell to the next one along each crossed axis
      std::size_t crossed = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        if (block.cells[a] == 1) continue;
        along[crossed] = centroids_[a].data();
        crossed_start[crossed] = start[a];
        crossed_scale[crossed] = scale[a];
        step[crossed] = a == 0 ? block.cells[1] * block.cells[2] : a == 1 ? block.cells[2] : 1;
        ++crossed;
      }
      const auto counts = crossed == 3   ? count_octants<3>(along, pieces, crossed_start, crossed_scale)
                          : crossed == 2 ? count_octants<2>(along, pieces, crossed_start, crossed_scale)
                                         : count_octants<1>(along, pieces, crossed_start, crossed_scale);
      for (int octant = 0; octant < 8; ++octant) {
        const auto number = counts[static_cast<std::size_t>(octant)];
        if (number != 0)
          parts[(octant >> 2 & 1) * step[0] + (octant >> 1 & 1) * step[1] + (octant & 1) * step[2]] =
              static_cast<double>(number);
      }
    } else {
      const auto cell = [&](std::size_t piece, std::size_t a) {
        return std::clamp(static_cast<int>(std::floor(start[a] + scale[a] * centroids_[a][piece])), 0,
                          block.cells[a] - 1);
      };
      for (std::size_t p = 0; p < pieces; ++p)
        parts[(cell(p, 0) * block.cells[1] + cell(p, 1)) * block.cells[2] + cell(p, 2)] += 1.0;
    }
    for (int n = 0; n < block.size(); ++n) parts[n] /= static_cast<double>(pieces);
  };
  return share_out_by_fours(balls.radius.size(), threads, [&](std::size_t first, std::size_t last) {
    return share_out_one_by_one(balls, first, last, *this, table, count_pieces);
  });
}

}  // namespace slfb::coupling
