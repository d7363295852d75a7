#pragma once

#include "correlations/materials.hpp"

namespace slfb::collision {

/// A sphere about to hit a wall in a liquid.
struct WetImpact {
  Sphere sphere;
  LiquidProperties liquid;
  double speed;      ///< impact speed U [m/s]
  double roughness;  ///< height of the surface roughness k [m]
};

}  // namespace slfb::collision
