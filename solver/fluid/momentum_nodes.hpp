#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "solver/fluid/column_grid.hpp"

namespace slfb::fluid {

/// The axis along which the column stands.
inline constexpr std::size_t vertical = 2;

inline std::size_t as_index(int value) { return static_cast<std::size_t>(value); }
/// Index of a value in a field that is stored column after column.
inline std::size_t index_of(int section, int level, int levels) {
  return as_index(section) * as_index(levels) + as_index(level);
}

/// Section nodes from first up to last, last excluded.
struct SectionRange {
  int first, last;
  [[nodiscard]] bool has(int section) const { return section >= first && section < last; }
};

/// Where one component of the velocity lives on a staggered ColumnGrid: on the faces across its direction, numbered
/// section node * levels + level.
///
/// The control volume of a node is made of the halves of the two cells beside the face (the whole cell where the other
/// side is a wall or the inlet), with the same shares for liquid volume, forces and fluxes (Peng 2014, Eq. 29): a force
/// scattered to the nodes and a velocity gathered from them are adjoint, which makes the exchange of momentum exact.
struct MomentumNodes {
  /// \param axis of the component: 0, 1, 2 for x, y, z
  /// \param closed walls at z = 0 and z = height instead of inlet and outlet
  MomentumNodes(const ColumnGrid& grid, std::size_t axis, LateralBoundary wall, bool closed);

  /// Number of nodes [-].
  [[nodiscard]] std::size_t size() const { return as_index(sections) * as_index(levels); }
  /// Where the velocity of a node is that of the liquid [m].
  [[nodiscard]] std::array<double, 3> position(std::size_t node) const;
  /// Area of a node's face [m²].
  [[nodiscard]] double face_area(int section) const;
  /// Distance between the pressure points on both sides of a node [m].
  [[nodiscard]] double spacing(int level) const;

  /// Distributes an extensive cell quantity to the nodes of a range.
  void scatter(SectionRange range, const std::vector<double>& cells, std::vector<double>& nodes) const;
  /// Means over the nodes of one cell of the section, layer by layer: the adjoint of scatter. \param value (node)
  template <class Value>
  void gather(int cell, const Value& value, double* result) const {
    const auto layers = as_index(grid.layers());
    if (axis == vertical) {
      const std::size_t node = index_of(cell, 0, levels);
      for (std::size_t k = 1; k < layers; ++k) result[k] = 0.5 * (value(node + k) + value(node + k + 1));
      result[0] = 0.5 * (value(node + 1) + value(node + std::min<std::size_t>(1, as_index(last))));
      if (closed) result[layers - 1] = value(node + layers - 1);
      return;
    }
    std::fill_n(result, layers, 0.0);
    for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      const int face = grid.face_of(cell, axis, side);
      if (face < 0) continue;
      const double part = share[as_index(face)][1 - side];
      const std::size_t node = index_of(face, 0, levels);
      for (std::size_t k = 0; k < layers; ++k) result[k] += part * value(node + k);
    }
  }

  const ColumnGrid& grid;
  std::size_t axis;
  bool closed;
  int sections = 0;                           ///< nodes in the section
  int levels = 0;                             ///< nodes over the height
  int first = 0, last = 0;                    ///< levels that are solved for; the others are given
  std::vector<std::array<int, 4>> neighbour;  ///< section nodes towards −x, +x, −y, +y; −1 at a wall
  std::vector<std::array<int, 2>> owner;      ///< the two cells beside the node (x, y) or the cell twice (z)
  std::vector<std::array<double, 2>> share;   ///< of each owner's volume that belongs to the node [-]
  std::vector<double> volume;                 ///< of the node [m³]
  /// Weights in ∇² of the four neighbours, less those of the node and its walls, and by level of the nodes below and
  /// above [1/m²]; and the part of a node's value that stands for a missing neighbour in convection [-].
  std::array<std::vector<double>, 4> lateral, mirror;
  std::vector<double> own, below, above;

 private:
  void build_links();
  void build_stencil(LateralBoundary wall);
};

}  // namespace slfb::fluid
