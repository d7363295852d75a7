#include "solver/coupling/void_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/coupling/sphere_overlap.hpp"

namespace slfb::coupling {

VolumeShares::VolumeShares(VoidFractionScheme scheme, int meshing_pieces, const fluid::ColumnGrid& grid,
                           double largest_radius)
    : scheme_(scheme), grid_(grid), stride_(1) {
  if (scheme == VoidFractionScheme::centroid) return;
  const auto across = [&](double width) {
    return static_cast<std::size_t>(std::ceil(2.0 * largest_radius / width)) + 1;
  };
  stride_ = across(grid.spacing(0)) * across(grid.spacing(1)) * across(grid.cell_height());
  if (scheme == VoidFractionScheme::particle_meshing) pieces_ = meshing_template(meshing_pieces);
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

int VolumeShares::square(std::size_t axis, double coordinate) const {
  const int k = static_cast<int>(std::floor((coordinate - grid_.lower(axis)) / grid_.spacing(axis)));
  const int squares = grid_.squares(axis);
  if (grid_.periodic()) return ((k % squares) + squares) % squares;
  return std::clamp(k, 0, squares - 1);
}

int VolumeShares::layer(double z) const {
  return std::clamp(static_cast<int>(std::floor(z / grid_.cell_height())), 0, grid_.layers() - 1);
}

std::uint32_t VolumeShares::cell_at(int ix, int iy, int layer) const {
  return static_cast<std::uint32_t>(grid_.cell_of_square(ix, iy) * grid_.layers() + layer);
}

void VolumeShares::add(std::size_t i, std::uint32_t cell, double share) {
  std::uint32_t* cells = &cell_[i * stride_];
  double* shares = &share_[i * stride_];
  int& count = count_[i];
  for (int m = 0; m < count; ++m)
    if (cells[m] == cell) {
      shares[m] += share;
      return;
    }
  cells[count] = cell;
  shares[count] = share;
  ++count;
}

void VolumeShares::centroid(const dem::Particles& particles, std::size_t i) {
  const auto x = particles.position.at(i);
  add(i, cell_at(square(0, x[0]), square(1, x[1]), layer(x[2])), 1.0);
}

void VolumeShares::particle_meshing(const dem::Particles& particles, std::size_t i) {
  const auto x = particles.position.at(i);
  const double r = particles.radius[i];
  const double share = 1.0 / static_cast<double>(pieces_.size());
  for (const auto& piece : pieces_)
    add(i, cell_at(square(0, x[0] + r * piece[0]), square(1, x[1] + r * piece[1]), layer(x[2] + r * piece[2])), share);
}

void VolumeShares::exact_overlap(const dem::Particles& particles, std::size_t i) {
  const auto x = particles.position.at(i);
  const double r = particles.radius[i];
  // Grid planes that cut the sphere, in units of its radius; outside the grid nothing is cut, so that the rest of a
  // sphere that presses into a wall stays in the last cell.
  constexpr std::size_t most = 16;
  std::array<std::array<double, most>, 3> plane{};
  std::array<std::array<int, most>, 3> position{};
  std::array<std::size_t, 3> parts{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double width = a == 2 ? grid_.cell_height() : grid_.spacing(a);
    const double origin = a == 2 ? 0.0 : grid_.lower(a);
    const int first = static_cast<int>(std::floor((x[a] - r - origin) / width));
    const int last = static_cast<int>(std::floor((x[a] + r - origin) / width));
    plane[a][0] = -1.0;
    for (int k = first; k <= last && parts[a] < most; ++k) {
      if (k > first) plane[a][parts[a]] = (origin + k * width - x[a]) / r;
      position[a][parts[a]] =
          a == 2 ? std::clamp(k, 0, grid_.layers() - 1) : square(a, grid_.lower(a) + (k + 0.5) * width);
      ++parts[a];
    }
  }
  // Volumes beyond each triple of planes; a cell's part is their alternating difference. The last plane is beyond the
  // sphere on every axis, where the volume is zero.
  const auto beyond = [&](std::size_t i0, std::size_t i1, std::size_t i2) {
    if (i0 == parts[0] || i1 == parts[1] || i2 == parts[2]) return 0.0;
    return unit_ball_octant(plane[0][i0], plane[1][i1], plane[2][i2]);
  };
  std::array<double, 125> octant{};
  const std::size_t n1 = parts[1] + 1, n2 = parts[2] + 1;
  const bool tabulated = (parts[0] + 1) * n1 * n2 <= octant.size();
  if (tabulated)
    for (std::size_t i0 = 0; i0 < parts[0]; ++i0)
      for (std::size_t i1 = 0; i1 < parts[1]; ++i1)
        for (std::size_t i2 = 0; i2 < parts[2]; ++i2) octant[(i0 * n1 + i1) * n2 + i2] = beyond(i0, i1, i2);
  const auto value = [&](std::size_t i0, std::size_t i1, std::size_t i2) {
    return tabulated ? octant[(i0 * n1 + i1) * n2 + i2] : beyond(i0, i1, i2);
  };
  constexpr double inverse_ball = 3.0 / (4.0 * std::numbers::pi);
  for (std::size_t i0 = 0; i0 < parts[0]; ++i0)
    for (std::size_t i1 = 0; i1 < parts[1]; ++i1)
      for (std::size_t i2 = 0; i2 < parts[2]; ++i2) {
        const double part = value(i0, i1, i2) - value(i0 + 1, i1, i2) - value(i0, i1 + 1, i2) - value(i0, i1, i2 + 1) +
                            value(i0 + 1, i1 + 1, i2) + value(i0 + 1, i1, i2 + 1) + value(i0, i1 + 1, i2 + 1) -
                            value(i0 + 1, i1 + 1, i2 + 1);
        if (part > 0.0) add(i, cell_at(position[0][i0], position[1][i1], position[2][i2]), part * inverse_ball);
      }
}

void VolumeShares::update(const dem::Particles& particles, int threads) {
  const std::size_t n = particles.size();
  cell_.resize(n * stride_);
  share_.resize(n * stride_);
  count_.assign(n, 0);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    switch (scheme_) {
      case VoidFractionScheme::centroid:
        centroid(particles, i);
        break;
      case VoidFractionScheme::particle_meshing:
        particle_meshing(particles, i);
        break;
      case VoidFractionScheme::exact_overlap:
        exact_overlap(particles, i);
        break;
    }
  }
}

void VolumeShares::scatter(const std::vector<double>& values, std::vector<double>& cells) const {
  cells.assign(grid_.size(), 0.0);
  for (std::size_t i = 0; i < count_.size(); ++i) {
    const std::uint32_t* cell = this->cells(i);
    const double* share = shares(i);
    for (int m = 0; m < count_[i]; ++m) cells[cell[m]] += share[m] * values[i];
  }
}

}  // namespace slfb::coupling
