#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "solver/dem/particles.hpp"
#include "solver/fluid/column_grid.hpp"

namespace slfb::coupling {

/// Shares φ_ic of each sphere's volume in the cells of the grid (Peng 2014, Eq. 29); they add up to one per sphere.
///
/// One set of shares makes the void fraction, gathers liquid values at the spheres and scatters forces back, so that
/// what one phase loses the other gains. Sphere i has `count(i)` of them at `cells(i)` and `shares(i)`.
class VolumeShares {
 public:
  /// Spheres must not be larger than `largest_radius` [m]; update() throws std::invalid_argument if one is.
  VolumeShares(VoidFractionScheme scheme, int meshing_pieces, const fluid::ColumnGrid& grid, double largest_radius);

  void update(const dem::Particles& particles, int threads) { update(particles.position, particles.radius, threads); }
  void update(const dem::VectorField& centres, const std::vector<double>& radius, int threads);

  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] const std::uint32_t* cells(std::size_t i) const { return &cell_[i * stride_]; }
  [[nodiscard]] const double* shares(std::size_t i) const { return &share_[i * stride_]; }
  [[nodiscard]] int count(std::size_t i) const { return count_[i]; }

  /// Σ_i φ_ic value_i per cell, of several fields at once. The spheres are cut into runs, the same at any number of
  /// threads, each with sums of its own, which are then added in the order of the runs.
  template <std::size_t fields>
  void scatter(const std::array<const std::vector<double>*, fields>& values,
               const std::array<std::vector<double>*, fields>& cells, int threads) const {
    const std::size_t n = count_.size(), size = grid_.size(), layers = static_cast<std::size_t>(grid_.layers());
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
          for (int m = 0; m < count_[i]; ++m) {
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

  /// Σ_c φ_ic cells_c per sphere, of several fields at once.
  template <std::size_t fields>
  void gather(const std::array<const std::vector<double>*, fields>& cells,
              const std::array<std::vector<double>*, fields>& values, int threads) const {
    for (auto* field : values) field->resize(count_.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::size_t i = 0; i < count_.size(); ++i)
      for (std::size_t f = 0; f < fields; ++f) (*values[f])[i] = gather(i, *cells[f]);
  }
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
  /// Cells along an axis; squares in the section, layers in z.
  struct Axis {
    double origin = 0.0, width = 0.0;  ///< [m]
    double per_length = 0.0;           ///< 1/width [1/m]
    int cells = 0;
    bool wraps = false;
  };
  /// Box of cells that a sphere can reach into.
  struct Block {
    std::array<int, 3> first, cells;
    [[nodiscard]] int size() const { return cells[0] * cells[1] * cells[2]; }
  };
  [[nodiscard]] Block block_around(const std::array<double, 3>& x, double reach) const;
  /// Shares of the block's cells, z fastest: by counting pieces, and exactly; and as the scheme says.
  void mesh_particle(const Block& block, const std::array<double, 3>& x, double r, double* parts) const;
  void cut_sphere(const Block& block, const std::array<double, 3>& x, double r, double* parts) const;
  void cut_one_sphere(const Block& block, const std::array<double, 3>& x, double r, double* parts) const;
  /// Cells and shares of spheres `first` to `first` + 3, cut exactly; returns the layer up to which they reach, or 0,
  /// having done nothing, where one of them lies in more than two cells along an axis.
  int cut_four_spheres(const dem::VectorField& centres, const std::vector<double>& radius, std::size_t first);
  [[nodiscard]] bool has_a_cell_per_square(const Block& block) const;
  /// Turns the shares of the block's cells, written where sphere i keeps its own, into cells and shares.
  void keep_occupied(std::size_t i, const Block& block);

  VoidFractionScheme scheme_;
  const fluid::ColumnGrid& grid_;
  double largest_radius_;
  std::array<Axis, 3> axis_;
  std::size_t stride_ = 1;
  std::vector<std::array<double, 3>> pieces_;
  /// Per square of the section: its cell and those of the next squares along x, y and both hold no other square.
  std::vector<char> alone_with_next_;
  std::vector<std::uint32_t> cell_;
  std::vector<double> share_;
  std::vector<int> count_;
  std::size_t occupied_layers_ = 0;       ///< no sphere reaches above these
  static constexpr std::size_t runs = 4;  ///< of spheres, in scatter
  mutable std::vector<double> sums_;      ///< of each run, cell and field
};

}  // namespace slfb::coupling
