#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "solver/support/vec3.hpp"

/// What the tests of the forces on single spheres share.
namespace slfb::coupling {

/// A turn of space about an axis that is along no coordinate.
inline Vec3 turned(Vec3 v) {
  const Vec3 axis = 1.0 / std::sqrt(14.0) * Vec3{1.0, -2.0, 3.0};
  const double c = std::cos(0.7), s = std::sin(0.7);  // Rodrigues
  return c * v + s * cross(axis, v) + (1.0 - c) * dot(axis, v) * axis;
}

inline void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace slfb::coupling
