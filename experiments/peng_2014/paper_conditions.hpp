#pragma once

#include <numbers>
#include <optional>
#include <string_view>

#include "correlations/foreign_sphere.hpp"
#include "correlations/materials.hpp"
#include "experiments/peng_2014/reference.hpp"

/// The bed, the spheres and the liquids of Peng et al. (2014) as the laws take them.
namespace slfb::paper {

/// Density of the fluidised glass [kg/m³]. Table 1 prints 2300; the paper's other numbers (16668 spheres of 3 mm,
/// 1450 Pa of weight, voidage 0.400 in 0.2 m) all need 2230, the handbook value of borosilicate glass.
inline constexpr double glass_density = 2230.0;

inline LiquidProperties water() { return {peng_2014().value("water_density"), peng_2014().value("water_viscosity")}; }

inline LiquidProperties sodium_iodide() {
  return {peng_2014().value("sodium_iodide_density"), peng_2014().value("sodium_iodide_viscosity")};
}

inline Sphere glass(double diameter) { return {diameter, glass_density}; }
inline Sphere steel(double diameter) { return {diameter, peng_2014().value("foreign_particle_density")}; }

/// Cross-section of the column [m²].
inline double column_area() {
  const double diameter = peng_2014().value("column_diameter");
  return std::numbers::pi / 4.0 * diameter * diameter;
}

/// Voidage of `mass` of glass of `density` that fills the column up to `height` [-].
inline double voidage_in_column(double mass, double density, double height) {
  return 1.0 - mass / (density * column_area() * height);
}

/// Voidage of 0.5255 kg of glass in the packed height of 0.2 m [-].
inline double packed_voidage() {
  return voidage_in_column(peng_2014().value("fluidised_mass_text"), glass_density, peng_2014().value("packed_height"));
}

/// Pressure drop that carries the apparent weight of 0.5255 kg of glass of `density` [Pa].
inline double bed_weight_pressure(double density) {
  return peng_2014().value("fluidised_mass_text") * (1.0 - water().density / density) * gravitational_acceleration /
         column_area();
}

/// The 6 mm steel sphere in 5 mm glass and water at the voidage that Eq. 36 gives at U_L, or at a printed one.
ForeignSphereInBed steel_in_glass(double superficial_velocity);
ForeignSphereInBed steel_in_glass(double superficial_velocity, double voidage);

/// Voidage of the bed of a system by Eq. 36, which the printed pairs of velocity and voidage follow within 0.006 [-].
/// Empty for a system that the paper does not have.
std::optional<double> voidage_by_equation_36(std::string_view system, double superficial_velocity);

/// Pressure drop of 5 mm glass packed at `voidage` up to the packed height by Ergun's equation, water [Pa].
double ergun_pressure(double voidage, double superficial_velocity);

/// Duration of a collision with the paper's stiffness and restitution [s].
double contact_time(Sphere a, Sphere b);

}  // namespace slfb::paper
