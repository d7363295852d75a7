#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/dem/particles.hpp"
#include "solver/fluid/column_grid.hpp"

namespace slfb::coupling {

/// Shares φ_ic of each sphere's volume in the cells of the grid (Peng 2014, Eq. 29); they add up to one per sphere.
///
/// One set of shares makes the void fraction, gathers liquid values at the spheres and scatters forces back, so that
/// what one phase loses the other gains. `stride` entries per sphere; unused ones have share 0.
class VolumeShares {
 public:
  VolumeShares(VoidFractionScheme scheme, int meshing_pieces, const fluid::ColumnGrid& grid, double largest_radius);

  void update(const dem::Particles& particles, int threads);

  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] const std::uint32_t* cells(std::size_t i) const { return &cell_[i * stride_]; }
  [[nodiscard]] const double* shares(std::size_t i) const { return &share_[i * stride_]; }
  [[nodiscard]] int count(std::size_t i) const { return count_[i]; }

  /// Σ_i φ_ic value_i per cell.
  void scatter(const std::vector<double>& values, std::vector<double>& cells) const;
  /// Σ_c φ_ic cells_c for sphere i.
  [[nodiscard]] double gather(std::size_t i, const std::vector<double>& cells) const {
    double sum = 0.0;
    const std::uint32_t* cell = this->cells(i);
    const double* share = shares(i);
    for (int m = 0; m < count_[i]; ++m) sum += share[m] * cells[cell[m]];
    return sum;
  }

  /// Centroids of N pieces of equal volume that make up the unit ball: shells of equal-area spiral points.
  static std::vector<std::array<double, 3>> meshing_template(int pieces);

 private:
  void centroid(const dem::Particles& particles, std::size_t i);
  void particle_meshing(const dem::Particles& particles, std::size_t i);
  void exact_overlap(const dem::Particles& particles, std::size_t i);
  [[nodiscard]] int square(std::size_t axis, double coordinate) const;
  [[nodiscard]] int layer(double z) const;
  [[nodiscard]] std::uint32_t cell_at(int ix, int iy, int layer) const;
  void add(std::size_t i, std::uint32_t cell, double share);

  VoidFractionScheme scheme_;
  const fluid::ColumnGrid& grid_;
  std::size_t stride_;
  std::vector<std::array<double, 3>> pieces_;
  std::vector<std::uint32_t> cell_;
  std::vector<double> share_;
  std::vector<int> count_;
};

}  // namespace slfb::coupling
