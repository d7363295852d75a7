#pragma once

#include <cmath>
#include <stdexcept>

#include "correlations/materials.hpp"

namespace slfb::fluidisation {

/// A packed bed about to fluidise.
struct PackedBed {
  Sphere sphere;
  LiquidProperties liquid;
  double voidage;  ///< ε of the packing [-]
};

/// Positive root of inertial·x² + viscous·x = weight, written so that it keeps its digits where one term is small.
/// \throws std::domain_error for a sphere that is not heavier than the liquid
inline double positive_root(double inertial, double viscous, double weight) {
  if (!(weight > 0.0)) throw std::domain_error("the sphere is not heavier than the liquid");
  return 2.0 * weight / (viscous + std::sqrt(viscous * viscous + 4.0 * inertial * weight));
}

}  // namespace slfb::fluidisation
