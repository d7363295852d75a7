#include "solver/run/fluctuation_window.hpp"

#include <cmath>

namespace slfb::simulation {

FluctuationWindow::FluctuationWindow(const fluid::ColumnGrid& grid, const std::array<double, 2>& heights) {
  const int row = grid.squares(1) / 2;
  for (int ix = 0; ix < grid.squares(0); ++ix) {
    if (!grid.square_inside(ix, row)) continue;
    for (int k = 0; k < grid.layers(); ++k) {
      const double z = (k + 0.5) * grid.cell_height();
      if (z < heights[0] || z > heights[1]) continue;
      cells_.push_back(static_cast<std::size_t>(grid.cell_of_square(ix, row) * grid.layers() + k));
      x_.push_back(grid.lower(0) + (ix + 0.5) * grid.spacing(0));
      z_.push_back(z);
    }
  }
}

void FluctuationWindow::sample(double time, const std::array<std::vector<double>, 3>& velocity,
                               LiquidFluctuation& result) const {
  result.time.push_back(time);
  const std::array<std::vector<double>*, 3> samples{&result.samples_x, &result.samples_y, &result.samples_z};
  for (std::size_t a = 0; a < 3; ++a)
    for (const std::size_t c : cells_) samples[a]->push_back(velocity[a][c]);
}

void FluctuationWindow::reduce(LiquidFluctuation& result) const {
  const std::size_t times = result.time.size(), cells = cells_.size();
  if (times == 0 || cells == 0) return;
  result.x = x_;
  result.z = z_;
  const std::array samples{&result.samples_x, &result.samples_y, &result.samples_z};
  const std::array means{&result.mean_x, &result.mean_y, &result.mean_z};
  const std::array deviations{&result.deviation_x, &result.deviation_y, &result.deviation_z};
  const std::array squares{&result.rms_x, &result.rms_y, &result.rms_z};
  const std::array series{&result.series_x, &result.series_y, &result.series_z};
  std::vector<double> squared_length(times * cells, 0.0);
  const auto per_time = 1.0 / static_cast<double>(times), per_cell = 1.0 / static_cast<double>(cells);
  for (std::size_t a = 0; a < 3; ++a) {
    for (auto* field : {means[a], deviations[a], squares[a]}) field->assign(cells, 0.0);
    series[a]->assign(times, 0.0);
    for (std::size_t k = 0; k < times * cells; ++k) (*means[a])[k % cells] += per_time * (*samples[a])[k];
    for (std::size_t k = 0; k < times * cells; ++k) {
      const double u = (*samples[a])[k] - (*means[a])[k % cells];
      (*deviations[a])[k % cells] += per_time * std::abs(u);
      (*squares[a])[k % cells] += per_time * u * u;
      (*series[a])[k / cells] += per_cell * std::abs(u);
      squared_length[k] += u * u;
    }
    for (double& square : *squares[a]) square = std::sqrt(square);
    samples[a]->clear();
  }
  result.deviation_vector.assign(cells, 0.0);
  result.series_vector.assign(times, 0.0);
  for (std::size_t k = 0; k < times * cells; ++k) {
    result.deviation_vector[k % cells] += per_time * std::sqrt(squared_length[k]);
    result.series_vector[k / cells] += per_cell * std::sqrt(squared_length[k]);
  }
}

}  // namespace slfb::simulation
