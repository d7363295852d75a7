#pragma once

#include <cmath>
#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::dem {

/// A plane with inward unit normal along an axis, or the inside of a vertical cylinder about the z axis.
struct Wall {
  enum class Kind { plane, cylinder };
  Kind kind = Kind::plane;
  int axis = 2;           ///< plane: 0, 1, 2
  double direction = 1;   ///< plane: the allowed side, +1 above `position`, −1 below
  double position = 0.0;  ///< plane: coordinate; cylinder: radius [m]

  /// True if a sphere of radius r at `point` does not touch the wall; without the root that gap() needs.
  [[nodiscard]] bool clear_of(Vec3 point, double r) const {
    if (kind == Kind::cylinder) {
      const double room = position - r;  // negative: there is no place where such a sphere does not touch
      return room >= 0.0 && point.x * point.x + point.y * point.y <= room * room;
    }
    const double coordinate = axis == 0 ? point.x : axis == 1 ? point.y : point.z;
    return direction * (coordinate - position) >= r;
  }

  struct Gap {
    double distance;  ///< from the wall to a point inside, negative outside [m]
    Vec3 outward;     ///< unit vector from the point towards the wall
  };
  [[nodiscard]] Gap gap(Vec3 point) const {
    if (kind == Kind::cylinder) {
      const double r = std::sqrt(point.x * point.x + point.y * point.y);
      if (r == 0.0) return {position, {1.0, 0.0, 0.0}};
      return {position - r, {point.x / r, point.y / r, 0.0}};
    }
    const double coordinate = axis == 0 ? point.x : axis == 1 ? point.y : point.z;
    Vec3 outward;
    (axis == 0 ? outward.x : axis == 1 ? outward.y : outward.z) = -direction;
    return {direction * (coordinate - position), outward};
  }
};

/// Walls of a scene: the distributor z = 0 first, then the sides (none of a periodic box), then the lid if the scene
/// has one. The z axis is the middle of the column.
inline std::vector<Wall> walls_of(const Scene& scene) {
  std::vector<Wall> walls{{Wall::Kind::plane, 2, 1.0, 0.0}};
  const Geometry& geometry = scene.geometry;
  if (geometry.shape == Shape::cylinder) {
    walls.push_back({Wall::Kind::cylinder, 0, 1.0, 0.5 * geometry.diameter});
  } else if (scene.fluid.wall != LateralBoundary::periodic) {
    for (int axis : {0, 1}) {
      const double half = 0.5 * geometry.width[static_cast<std::size_t>(axis)];
      walls.push_back({Wall::Kind::plane, axis, 1.0, -half});
      walls.push_back({Wall::Kind::plane, axis, -1.0, half});
    }
  }
  if (scene.outlet.rule == OutletRule::lid) walls.push_back({Wall::Kind::plane, 2, -1.0, geometry.height});
  return walls;
}

}  // namespace slfb::dem
