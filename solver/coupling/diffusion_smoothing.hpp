#pragma once

#include <array>
#include <vector>

#include "solver/fluid/column_grid.hpp"

namespace slfb::coupling {

/// Spreads what the spheres give to the cells, and what they read from them, over a length that does not depend on the
/// cells (Sun and Xiao 2015, Int. J. Multiphase Flow 68, 73).
///
/// Diffusion over the time b²/4 is the Gaussian exp(−|x|²/b²) of bandwidth b (variance b²/2 along each axis) where no
/// wall is near; no flux crosses a wall, so that what is spread stays in the column. With V the cells' volumes and L
/// the Laplacian of the faces (area over distance), n explicit steps s = b²/4n are
///
///   scatter  q ← (I − s L V⁻¹)ⁿ q   of what a cell holds: volume, force; its sum stays, nothing becomes negative
///   gather   g ← (I − s V⁻¹ L)ⁿ g   of local values: velocity, void fraction; a uniform field stays
///
/// each the other's transpose, so that momentum is still exchanged to round-off.
class DiffusionSmoothing {
 public:
  /// The grid must outlive the smoothing. \param length b [m]; 0 leaves every field as it is
  DiffusionSmoothing(const fluid::ColumnGrid& grid, double length);

  /// Both change a field of grid.size() values in place; the result does not depend on the number of threads.
  void scatter(std::vector<double>& extensive, int threads = 1);
  void gather(std::vector<double>& field, int threads = 1);

  /// Diffusion steps of one smoothing [-].
  [[nodiscard]] int steps() const { return steps_; }

 private:
  /// Lateral neighbours of a cell of the section and what one step takes over of the difference to each [-].
  struct Exchange {
    std::array<std::size_t, 4> cell;
    std::array<double, 4> weight;
  };

  const fluid::ColumnGrid& grid_;
  int steps_ = 0;
  std::vector<Exchange> lateral_;
  double vertical_ = 0.0;  ///< the same between layers [-]
  std::vector<double> next_;
};

}  // namespace slfb::coupling
