#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "solver/dem/vec3.hpp"

/// What the tests of the forces on single spheres share.
namespace slfb::coupling {

/// A turn of space about an axis that is along no coordinate.
inline dem::Vec3 turned(dem::Vec3 v) {
  const dem::Vec3 axis = 1.0 / std::sqrt(14.0) * dem::Vec3{1.0, -2.0, 3.0};
  const double c = std::cos(0.7), s = std::sin(0.7);  // Rodrigues
  return c * v + s * dem::cross(axis, v) + (1.0 - c) * dem::dot(axis, v) * axis;
}

inline void expect_near(dem::Vec3 a, dem::Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace slfb::coupling
