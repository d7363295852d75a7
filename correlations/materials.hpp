#pragma once

#include <numbers>

namespace slfb {

inline constexpr double gravitational_acceleration = 9.81;  ///< g [m/s²], the value of Peng 2014

/// A smooth sphere.
struct Sphere {
  double diameter;  ///< [m]
  double density;   ///< [kg/m³]

  [[nodiscard]] constexpr double volume() const { return std::numbers::pi / 6.0 * diameter * diameter * diameter; }
  [[nodiscard]] constexpr double weight() const { return volume() * density * gravitational_acceleration; }
};

/// A Newtonian liquid.
struct LiquidProperties {
  double density;    ///< [kg/m³]
  double viscosity;  ///< [Pa s]
};

/// Reynolds number ρ d w / μ [-] of a sphere at slip velocity w.
constexpr double reynolds_number(LiquidProperties liquid, double diameter, double velocity) {
  return liquid.density * diameter * velocity / liquid.viscosity;
}

/// Archimedes number d³ ρ (ρ_P − ρ) g / μ² [-].
constexpr double archimedes_number(Sphere sphere, LiquidProperties liquid) {
  return sphere.diameter * sphere.diameter * sphere.diameter * liquid.density * (sphere.density - liquid.density) *
         gravitational_acceleration / (liquid.viscosity * liquid.viscosity);
}

/// Density of a homogeneous suspension ρ_M = ε ρ + (1 − ε) ρ_P [kg/m³].
constexpr double suspension_density(double voidage, Sphere sphere, LiquidProperties liquid) {
  return voidage * liquid.density + (1.0 - voidage) * sphere.density;
}

}  // namespace slfb
