#pragma once

#include <array>
#include <vector>

#include "solver/fluid/column_grid.hpp"
#include "solver/io/run_result.hpp"

namespace slfb {

/// Takes samples of the liquid's velocity in the window of Peng 2014, Eq. 37, and reduces them.
class FluctuationWindow {
 public:
  /// Cells on the positive side of the plane y = 0 with 0.1 m < z < 0.2 m; none in a column that ends below.
  explicit FluctuationWindow(const fluid::ColumnGrid& grid);

  /// Adds the velocities of one instant [m/s]; `velocity` holds all cells of the grid.
  void sample(double time, const std::array<std::vector<double>, 3>& velocity, LiquidFluctuation& result) const;

  /// From the samples to means and deviations from them; the samples themselves are dropped.
  void reduce(LiquidFluctuation& result) const;

 private:
  std::vector<std::size_t> cells_;
  std::vector<double> x_, z_;
};

}  // namespace slfb
