#include "solver/coupling/diffusion_smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace slfb::coupling {

DiffusionSmoothing::DiffusionSmoothing(const fluid::ColumnGrid& grid, double length) : grid_(grid) {
  const double time = 0.25 * length * length;  // [m²], for a diffusivity of 1
  double fastest = 0.0;                        // largest rate at which a cell empties [1/m²]
  vertical_ = grid.layers() > 1 ? 1.0 / (grid.cell_height() * grid.cell_height()) : 0.0;
  for (int c = 0; c < grid.cells(); ++c) {
    Exchange exchange{};
    double sum = 2.0 * vertical_;
    for (std::size_t n = 0; n < 4; ++n) {
      const std::size_t axis = n / 2, side = n % 2;
      const int face = grid.face_of(c, axis, side);
      exchange.cell[n] = static_cast<std::size_t>(c);
      if (face < 0) continue;
      const auto& between = grid.faces(axis)[static_cast<std::size_t>(face)];
      exchange.cell[n] = static_cast<std::size_t>(side == 0 ? between.first : between.second);
      exchange.weight[n] = between.length / (grid.spacing(axis) * grid.area(c));
      sum += exchange.weight[n];
    }
    fastest = std::max(fastest, sum);
    lateral_.push_back(exchange);
  }
  // A step that takes at most half of a cell keeps its rest positive and damps every wave without turning its sign;
  // taking all of it would leave a checkerboard as it is.
  steps_ = static_cast<int>(std::ceil(2.0 * fastest * time));
  if (steps_ == 0) return;
  const double step = time / steps_;
  vertical_ *= step;
  for (auto& exchange : lateral_)
    for (double& weight : exchange.weight) weight *= step;
}

void DiffusionSmoothing::gather(std::vector<double>& field, int threads) {
  const auto layers = static_cast<std::size_t>(grid_.layers());
  next_.resize(field.size());
  for (int step = 0; step < steps_; ++step) {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::size_t c = 0; c < lateral_.size(); ++c) {
      const Exchange& exchange = lateral_[c];
      const double* own = &field[c * layers];
      double* result = &next_[c * layers];
      for (std::size_t k = 0; k < layers; ++k) {
        double change = 0.0;
        for (std::size_t n = 0; n < 4; ++n)
          change += exchange.weight[n] * (field[exchange.cell[n] * layers + k] - own[k]);
        result[k] = own[k] + change;
      }
      for (std::size_t k = 1; k < layers; ++k) {
        const double flow = vertical_ * (own[k] - own[k - 1]);
        result[k - 1] += flow;
        result[k] -= flow;
      }
    }
    field.swap(next_);
  }
}

void DiffusionSmoothing::scatter(std::vector<double>& extensive, int threads) {
  if (steps_ == 0) return;
  // V⁻¹ (I − s L V⁻¹)ⁿ = (I − s V⁻¹ L)ⁿ V⁻¹: the same steps on the content per volume.
  const auto layers = static_cast<std::size_t>(grid_.layers());
  const auto volume = [&](std::size_t n) { return grid_.volume(static_cast<int>(n / layers)); };
  for (std::size_t n = 0; n < extensive.size(); ++n) extensive[n] /= volume(n);
  gather(extensive, threads);
  for (std::size_t n = 0; n < extensive.size(); ++n) extensive[n] *= volume(n);
}

}  // namespace slfb::coupling
