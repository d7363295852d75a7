#include "solver/coupling/void_fraction/particle_meshing.hpp"

#include <algorithm>
#include <cmath>
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

std::size_t ParticleMeshing::share_out(const Balls& balls, ShareTable& table, int threads) const {
  const auto count_pieces = [&](const CellBlock& block, const std::array<double, 3>& x, double r, double* parts) {
    std::array<double, 3> start{}, scale{};
    for (std::size_t a = 0; a < 3; ++a) {
      const ShareTable::Axis& axis = table.axis(a);
      start[a] = (x[a] - axis.origin) * axis.per_length - block.first[a];
      scale[a] = r * axis.per_length;
    }
    const auto cell = [&](const std::array<double, 3>& piece, std::size_t a) {
      return std::clamp(static_cast<int>(std::floor(start[a] + scale[a] * piece[a])), 0, block.cells[a] - 1);
    };
    std::fill_n(parts, block.size(), 0.0);
    for (const auto& piece : pieces_)
      parts[(cell(piece, 0) * block.cells[1] + cell(piece, 1)) * block.cells[2] + cell(piece, 2)] += 1.0;
    for (int n = 0; n < block.size(); ++n) parts[n] /= static_cast<double>(pieces_.size());
  };
  return share_out_by_fours(balls.radius.size(), threads, [&](std::size_t first, std::size_t last) {
    return share_out_one_by_one(balls, first, last, *this, table, count_pieces);
  });
}

}  // namespace slfb::coupling
