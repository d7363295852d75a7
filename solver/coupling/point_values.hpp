#pragma once

#include <array>
#include <vector>

#include "solver/fluid/column_grid.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::coupling {

/// What spheres read from a cell: one cache line, so that reading all of it costs as much as reading one value.
struct alignas(64) CellValues {
  enum Field : std::size_t { voidage, velocity_x, velocity_y, velocity_z, stress_x, stress_y, stress_z, unused };
  std::array<double, 8> value{};  ///< voidage [-], liquid velocity [m/s], −∇p + ∇·τ with the dynamic pressure [N/m³]
};

/// Voidage and velocity of the liquid at a point, from the values at the centres of the cells.
///
/// Gradient: φ_p = φ_c + (x_p − x_c)·∇φ of the cell c that holds the point, ∇φ by the divergence theorem with means of
/// neighbours on the faces (Peng 2014, Eqs. 30, 31); a wall's face has the cell's own value, or velocity 0 without
/// slip. Trilinear: between the eight nearest centres; beyond the outermost ones the values go on unchanged.
class PointValues {
 public:
  /// The grid must outlive the values. \param no_slip velocity 0 on the faces of walls
  PointValues(const fluid::ColumnGrid& grid, Interpolation scheme, bool no_slip);

  /// ∇ of voidage [1/m] and of each velocity component [1/s] in the cell that holds x [m], by the divergence theorem;
  /// `cells` has grid.size() entries. Points outside the column count to its nearest cell.
  [[nodiscard]] std::array<std::array<double, 3>, 4> gradient(const std::array<double, 3>& x,
                                                              const std::vector<CellValues>& cells) const;
  /// Voidage [-] and velocity [m/s] at x [m], by the scheme.
  [[nodiscard]] std::array<double, 4> at(const std::array<double, 3>& x, const std::vector<CellValues>& cells) const;

 private:
  /// The cell that holds x.
  [[nodiscard]] std::size_t home(const std::array<double, 3>& x) const;
  [[nodiscard]] std::size_t cell(int ix, int iy, int layer) const;
  [[nodiscard]] std::array<double, 4> by_gradient(const std::array<double, 3>& x,
                                                  const std::vector<CellValues>& cells) const;
  [[nodiscard]] std::array<double, 4> trilinear(const std::array<double, 3>& x,
                                                const std::vector<CellValues>& cells) const;

  const fluid::ColumnGrid& grid_;
  Interpolation scheme_;
  bool no_slip_;
};

}  // namespace slfb::coupling
