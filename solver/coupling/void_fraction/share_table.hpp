#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/fluid/column_grid.hpp"

namespace slfb::coupling {

/// A box of cells: squares of the section along x and y, layers along z.
struct CellBlock {
  std::array<int, 3> first, cells;
  [[nodiscard]] int size() const { return cells[0] * cells[1] * cells[2]; }
};

/// In which cells of a grid each sphere lies, and with which share φ of its volume [-]: what a void-fraction scheme
/// fills. Sphere i has count(i) entries at cells(i) and shares(i).
class ShareTable {
 public:
  /// Room for spheres that reach at most `largest_reach` [m] from their centre, along every axis.
  ShareTable(const fluid::ColumnGrid& grid, double largest_reach);

  void resize(std::size_t spheres);
  [[nodiscard]] std::size_t size() const { return count_.size(); }

  [[nodiscard]] const std::uint32_t* cells(std::size_t i) const { return &cell_[i * stride_]; }
  [[nodiscard]] const double* shares(std::size_t i) const { return &share_[i * stride_]; }
  [[nodiscard]] int count(std::size_t i) const { return count_[i]; }
  [[nodiscard]] std::uint32_t* cells(std::size_t i) { return &cell_[i * stride_]; }
  [[nodiscard]] double* shares(std::size_t i) { return &share_[i * stride_]; }
  void set_count(std::size_t i, int count) { count_[i] = count; }

  /// Cells along an axis; squares in the section, layers in z.
  struct Axis {
    double origin = 0.0, width = 0.0;  ///< [m]
    double per_length = 0.0;           ///< 1/width [1/m]
    int cells = 0;
    bool wraps = false;  ///< periodic; otherwise what presses into a wall stays in the last cell
  };
  [[nodiscard]] const Axis& axis(std::size_t a) const { return axis_[a]; }
  /// The cells within `reach` [m] of a point along each axis.
  [[nodiscard]] CellBlock block_around(const std::array<double, 3>& x, double reach) const;
  /// No two squares of a block of at most two by two belong to one cell, and none lies across a side of the grid.
  [[nodiscard]] bool has_a_cell_per_square(const CellBlock& block) const {
    const int x = block.first[0], y = block.first[1];
    return x >= 0 && x < axis_[0].cells && y >= 0 && y < axis_[1].cells &&
           alone_with_next_[static_cast<std::size_t>(y * axis_[0].cells + x)] != 0;
  }
  /// Cell of a square of the section in the lowest layer of a block.
  [[nodiscard]] int lowest_cell(int ix, int iy, const CellBlock& block) const {
    return grid_.cell_of_square(ix, iy) * grid_.layers() + block.first[2];
  }
  /// Turns the parts of the block's cells, z fastest, which shares(i) holds, into cells and shares of sphere i.
  void keep_occupied(std::size_t i, const CellBlock& block);

 private:
  const fluid::ColumnGrid& grid_;
  std::array<Axis, 3> axis_;
  std::size_t stride_ = 1;  ///< entries that each sphere has room for
  /// Per square of the section: its cell and those of the next squares along x, y and both hold no other square.
  std::vector<char> alone_with_next_;
  std::vector<std::uint32_t> cell_;
  std::vector<double> share_;
  std::vector<int> count_;
};

}  // namespace slfb::coupling
