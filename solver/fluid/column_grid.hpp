#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "solver/scene/scene.hpp"

namespace slfb::fluid {

/// Mesh of a vertical column: a section of square cells, cut by the round wall, extruded in equal layers.
///
/// Cut cells have their exact area; one smaller than half a square is joined to the neighbour towards the axis, so
/// that no cell is tiny and the section area stays exact. Fields are stored column after column: index
/// cell * layers + layer.
class ColumnGrid {
 public:
  /// The mesh of a scene: fluid.cells_across squares over the diameter or over width[0] in the three-dimensional tier,
  /// else a single cell; layers of about fluid.cell_height.
  explicit ColumnGrid(const Scene& scene);
  /// A single cell that holds the whole column of a scene, whatever its fluid.* keys say.
  static ColumnGrid single_cell(const Scene& scene);

  /// A vertical face between two cells of the section.
  struct Face {
    int first, second;  ///< cells on the lower and the upper side along the axis
    double length;      ///< wetted length of the face in the section [m]
    double middle;      ///< of the wetted length, across the axis [m]
  };

  /// Cells of the section, layers over the height, cells in all [-].
  [[nodiscard]] int cells() const { return static_cast<int>(area_.size()); }
  [[nodiscard]] int layers() const { return layers_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(cells() * layers_); }
  /// Height of a layer and of the column [m].
  [[nodiscard]] double cell_height() const { return height_; }
  [[nodiscard]] double column_height() const { return height_ * layers_; }
  /// Width of a square along an axis [m]; both are equal except where a box is not a whole number of squares deep.
  [[nodiscard]] double spacing(std::size_t axis) const { return spacing_[axis]; }
  /// Squares along an axis of the section [-], those outside the wall included, and where the first begins [m].
  [[nodiscard]] int squares(std::size_t axis) const { return squares_[axis]; }
  [[nodiscard]] double lower(std::size_t axis) const { return lower_[axis]; }
  /// Area of the section and of a cell in it [m²], volume of a cell [m³].
  [[nodiscard]] double section_area() const { return section_area_; }
  [[nodiscard]] double area(int cell) const { return area_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] double volume(int cell) const { return area(cell) * height_; }
  [[nodiscard]] const std::vector<double>& areas() const { return area_; }
  /// Centre of the cell's own square, which lies inside the wall [m].
  [[nodiscard]] std::array<double, 2> centre(int cell) const { return centre_[static_cast<std::size_t>(cell)]; }
  /// Centroid of the cell with what is joined to it [m].
  [[nodiscard]] std::array<double, 2> centroid(int cell) const { return centroid_[static_cast<std::size_t>(cell)]; }
  /// Distance along an axis from a point of the section to the wall below (side 0) or above (side 1) it [m]; infinite
  /// where no wall can be felt: across a periodic direction, and across a single cell, where the flow is plane.
  [[nodiscard]] double wall_distance(const std::array<double, 2>& point, std::size_t axis, std::size_t side) const;
  /// Faces across x (axis 0) or y (axis 1).
  [[nodiscard]] const std::vector<Face>& faces(std::size_t axis) const { return faces_[axis]; }
  /// Face below (side 0) or above (side 1) a cell along an axis; -1 at a wall.
  [[nodiscard]] int face_of(int cell, std::size_t axis, std::size_t side) const {
    return face_of_[axis][2 * static_cast<std::size_t>(cell) + side];
  }
  /// Section cell of a square; squares outside the wall belong to the nearest cell, so that no volume is lost.
  [[nodiscard]] int cell_of_square(int ix, int iy) const {
    return cell_of_square_[static_cast<std::size_t>(iy * squares_[0] + ix)];
  }
  /// True if the centre of the square lies inside the column.
  [[nodiscard]] bool square_inside(int ix, int iy) const;
  /// Radius of the round wall [m]; 0 for a box.
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] bool periodic() const { return periodic_; }

 private:
  /// \param layers over the height; \param across squares over the width; \param many_deep a box may be several squares
  /// deep
  ColumnGrid(const Scene& scene, int layers, int across, bool many_deep);

  bool cylinder_ = true, periodic_ = false;
  double radius_ = 0.0;
  int layers_ = 1;
  double height_ = 0.0, section_area_ = 0.0;
  std::array<int, 2> squares_{1, 1};
  std::array<double, 2> lower_{0.0, 0.0}, spacing_{0.0, 0.0};
  std::vector<double> area_;
  std::vector<std::array<double, 2>> centre_, centroid_;
  std::array<std::vector<Face>, 2> faces_;
  std::array<std::vector<int>, 2> face_of_;
  std::vector<int> cell_of_square_;
};

/// Area of the part of the rectangle [x0, x1] x [y0, y1] inside the circle of radius R about the origin [m²]; exact.
double circle_rectangle_area(double radius, double x0, double x1, double y0, double y1);

}  // namespace slfb::fluid
