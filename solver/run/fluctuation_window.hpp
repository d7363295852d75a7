#pragma once

#include <array>
#include <vector>

#include "solver/fluid/column_grid.hpp"
#include "solver/io/run_result.hpp"

namespace slfb::simulation {

/// Samples of the liquid's velocity in a window of the plane y = 0, and their fluctuation (Peng 2014, Eq. 37).
class FluctuationWindow {
 public:
  /// Cells on the positive side of the plane y = 0 whose centres lie at heights from `heights[0]` to `heights[1]` [m];
  /// none in a column that ends below.
  FluctuationWindow(const fluid::ColumnGrid& grid, const std::array<double, 2>& heights);

  /// Adds the velocities of one instant [m/s]; `velocity` holds all cells of the grid.
  void sample(double time, const std::array<std::vector<double>, 3>& velocity, LiquidFluctuation& result) const;

  /// From the samples to means and deviations from them; the samples themselves are dropped.
  void reduce(LiquidFluctuation& result) const;

 private:
  std::vector<std::size_t> cells_;
  std::vector<double> x_, z_;
};

}  // namespace slfb::simulation
