#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/coupling/void_fraction/share_scheme.hpp"

namespace slfb::coupling {

/// Shares φ_ic of each sphere's volume in the cells of the grid (Peng 2014, Eq. 29); they add up to one per sphere.
///
/// One set of shares makes the void fraction, gathers liquid values at the spheres and scatters forces back, so that
/// what one phase loses the other gains. Sphere i has `count(i)` of them at `cells(i)` and `shares(i)`; a field of
/// cells has grid.size() numbers, index section cell * layers + layer.
class VolumeShares {
 public:
  /// \param largest_radius spheres must not be larger [m]
  VolumeShares(std::unique_ptr<ShareScheme> scheme, const fluid::ColumnGrid& grid, double largest_radius);

  /// The shares of spheres where they are now. \throws std::invalid_argument if one is larger than the largest radius
  void update(const dem::Particles& particles, int threads) { update(particles.position, particles.radius, threads); }
  void update(const dem::VectorField& centres, const std::vector<double>& radius, int threads);

  [[nodiscard]] const std::uint32_t* cells(std::size_t i) const { return table_.cells(i); }
  [[nodiscard]] const double* shares(std::size_t i) const { return table_.shares(i); }
  [[nodiscard]] int count(std::size_t i) const { return table_.count(i); }

  /// Σ_i φ_ic value_i per cell, of several fields at once. The spheres are cut into runs, the same at any number of
  /// threads, each with sums of its own, which are then added in the order of the runs.
  template <std::size_t fields>
  void scatter(const std::array<const std::vector<double>*, fields>& values,
               const std::array<std::vector<double>*, fields>& cells, int threads) const {
    const std::size_t n = table_.size(), size = grid_.size(), layers = static_cast<std::size_t>(grid_.layers());
    for (auto* field : cells) field->assign(size, 0.0);
    sums_.resize(runs * size * fields);
#pragma omp parallel num_threads(threads)
    {
#pragma omp for schedule(static, 1)
      for (std::size_t run = 0; run < runs; ++run) {
        double* sums = &sums_[run * size * fields];
        for (std::size_t start = 0; start < size; start += layers)
          std::fill_n(sums + start * fields, occupied_layers_ * fields, 0.0);
        for (std::size_t i = n * run / runs; i < n * (run + 1) / runs; ++i)
          for (int m = 0; m < count(i); ++m) {
            const double share = shares(i)[m];
            double* sum = sums + this->cells(i)[m] * fields;
            for (std::size_t f = 0; f < fields; ++f) sum[f] += share * (*values[f])[i];
          }
      }
#pragma omp for schedule(static)
      for (std::size_t start = 0; start < size; start += layers)
        for (std::size_t c = start; c < start + occupied_layers_; ++c)
          for (std::size_t f = 0; f < fields; ++f) {
            double sum = 0.0;
            for (std::size_t run = 0; run < runs; ++run) sum += sums_[(run * size + c) * fields + f];
            (*cells[f])[c] = sum;
          }
    }
  }
  void scatter(const std::vector<double>& values, std::vector<double>& cells) const {
    scatter<1>({&values}, {&cells}, 1);
  }

  /// Σ_c φ_ic cells_c for sphere i.
  [[nodiscard]] double gather(std::size_t i, const std::vector<double>& cells) const {
    double sum = 0.0;
    const std::uint32_t* cell = this->cells(i);
    const double* share = shares(i);
    for (int m = 0; m < count(i); ++m) sum += share[m] * cells[cell[m]];
    return sum;
  }

 private:
  std::unique_ptr<ShareScheme> scheme_;
  const fluid::ColumnGrid& grid_;
  double largest_radius_;
  ShareTable table_;
  std::size_t occupied_layers_ = 0;       ///< no sphere reaches above these
  static constexpr std::size_t runs = 4;  ///< of spheres, in scatter
  mutable std::vector<double> sums_;      ///< of each run, cell and field
};

}  // namespace slfb::coupling
