#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "solver/coupling/void_fraction/sphere_overlap.hpp"

/// The exact answer of a staggered grid to the force of one sphere: the reference of the self-induced velocity.
namespace slfb::coupling {

/// A periodic staggered grid of unit cells with μ = ρ = 1, in which the linearised equations
/// ∂u/∂t + U ∂u/∂x = −∇p + ∇²u + f, ∇·u = 0 are diagonal in the Fourier modes of the grid.
///
/// A force along x is handed to cells by shares, halved onto the two faces of each cell, and the velocity gathered back
/// the same way, as StaggeredLiquid and VolumeShares do. Along x the grid alternates instead of repeating where liquid
/// flows (U ≠ 0), so that no wake comes back to its source; its images then cancel in the mean.
class OseenGrid {
 public:
  OseenGrid(int cells_along, int cells_across) : along_(cells_along), across_(cells_across) {}

  struct Share {
    std::array<double, 3> cell;  ///< lower corner
    double share;
  };

  /// Shares of a sphere by exact overlap.
  static std::vector<Share> shares(const std::array<double, 3>& centre, double radius) {
    std::array<int, 3> lower{}, cells{};
    std::array<PlaneRow, 3> planes;
    for (std::size_t a = 0; a < 3; ++a) {
      lower[a] = static_cast<int>(std::floor(centre[a] - radius));
      cells[a] = static_cast<int>(std::ceil(centre[a] + radius)) - lower[a];
      planes[a] = {(lower[a] + 1 - centre[a]) / radius, 1.0 / radius, cells[a] - 1};
    }
    std::vector<double> parts(static_cast<std::size_t>(cells[0] * cells[1] * cells[2]));
    unit_ball_parts(planes[0], planes[1], planes[2], parts.data());
    std::vector<Share> shares;
    std::size_t n = 0;
    for (int i = 0; i < cells[0]; ++i)
      for (int j = 0; j < cells[1]; ++j)
        for (int k = 0; k < cells[2]; ++k, ++n)
          if (parts[n] > 0.0)
            shares.push_back({{double(lower[0] + i), double(lower[1] + j), double(lower[2] + k)}, parts[n]});
    return shares;
  }

  /// Velocity gathered by `shares` from their own unit force in liquid passing with `speed`, `steps` implicit Euler
  /// steps of `time_step` after its start; steady for `steps` = 0.
  [[nodiscard]] double response(const std::vector<Share>& shares, double speed, double time_step = 1.0,
                                int steps = 0) const {
    double sum = 0.0;
    const double shift = speed != 0.0 ? 0.5 : 0.0;
    for (int i = 0; i < along_; ++i)
      for (int j = 0; j < across_; ++j)
        for (int k = 0; k < across_; ++k) {
          const std::array<double, 3> q{2.0 * std::numbers::pi * (i + shift) / along_,
                                        2.0 * std::numbers::pi * j / across_, 2.0 * std::numbers::pi * k / across_};
          std::array<double, 3> square{};
          for (std::size_t a = 0; a < 3; ++a) square[a] = std::pow(2.0 * std::sin(0.5 * q[a]), 2);
          const double laplace = square[0] + square[1] + square[2];
          if (laplace == 0.0) continue;  // a uniform velocity, held at zero
          std::complex<double> form = 0.0;
          for (const auto& [cell, share] : shares)
            form += std::polar(share, q[0] * cell[0] + q[1] * cell[1] + q[2] * cell[2]);
          const double pushed = std::norm(form) * std::pow(std::cos(0.5 * q[0]), 2) * (1.0 - square[0] / laplace);
          const std::complex<double> rate{laplace, speed * std::sin(q[0])};
          const std::complex<double> left = steps > 0 ? std::pow(1.0 / (1.0 + rate * time_step), steps) : 0.0;
          sum += (pushed * (1.0 - left) / rate).real();
        }
    return sum / (static_cast<double>(along_) * across_ * across_);
  }

  /// What the images of a cubic lattice take from the steady Stokes velocity, 2.8373/(6 π L) (Hasimoto 1959).
  [[nodiscard]] double images() const { return 2.837297 / (6.0 * std::numbers::pi * along_); }

 private:
  int along_, across_;
};

}  // namespace slfb::coupling
