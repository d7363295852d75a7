#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"
#include "correlations/law_parameters.hpp"

namespace slfb {

/// Every argument that some law takes, in SI units. The defaults are the bed of Peng 2014, Table 1 (5 mm glass of
/// 2230 kg/m³, 6 mm steel, water) at the first voidage of its Fig. 13.
struct LawArguments {
  double voidage = 0.46;                 ///< ε [-]
  double reynolds = 100.0;               ///< Re as the law defines it [-]
  double diameter = 5e-3;                ///< d_1, bed particle [m]
  double particle_density = 2230.0;      ///< ρ_1 [kg/m³]
  double foreign_diameter = 6e-3;        ///< d_2 [m]
  double foreign_density = 7800.0;       ///< ρ_2 [kg/m³]
  double liquid_density = 998.2;         ///< ρ [kg/m³]
  double viscosity = 1e-3;               ///< μ [Pa s]
  double superficial_velocity = 0.06;    ///< U_L [m/s]
  double settling_velocity = 0.097;      ///< V_2 [m/s]; Table 2 of Peng 2014 at U_L = 0.06 m/s
  double column_diameter = 0.05;         ///< D [m]
  double kinetic_energy = 1e-3;          ///< q_p² [m²/s²]; lower end of Fig. 18 of Peng 2014
  double foreign_kinetic_energy = 1e-3;  ///< q² of the foreign sphere [m²/s²]; assumed equal to that of the bed
  double transition = 0.5;    ///< f of Ružička (2006) [-], not at hand: assumed midway between its limits 0 and 1
  double impact_speed = 0.1;  ///< [m/s]
  double roughness = 1e-6;    ///< [m]; assumed, of the order of polished glass

  [[nodiscard]] Sphere particle() const { return {diameter, particle_density}; }
  [[nodiscard]] Sphere foreign() const { return {foreign_diameter, foreign_density}; }
  [[nodiscard]] LiquidProperties liquid() const { return {liquid_density, viscosity}; }
  [[nodiscard]] ForeignSphereInBed foreign_sphere_in_bed() const {
    return {particle(), foreign(), liquid(), voidage, superficial_velocity};
  }
};

/// One argument as a user meets it.
struct Argument {
  std::string_view name;    ///< "voidage"; the command line writes "--voidage", with '-' for '_'
  std::string_view symbol;  ///< as the equations of the laws write it
  std::string_view unit;
  std::string_view meaning;
  double LawArguments::*value;
  bool zero_allowed = false;
  double upper = std::numeric_limits<double>::infinity();  ///< largest value allowed
  [[nodiscard]] bool allows(double x) const {
    return (x > 0.0 || (zero_allowed && x == 0.0)) && x <= upper && x < std::numeric_limits<double>::infinity();
  }
};

/// Every argument, in the order of LawArguments.
std::span<const Argument> all_arguments();

/// A named number that a law gives.
struct LawValue {
  std::string_view name;
  double value;
  std::string_view unit;
};

/// What a law answers to a set of arguments.
struct LawAnswer {
  std::vector<LawValue> quantities;
  /// Re of the answer, to compare with the range of the law [-]; not a number where the law knows no Re.
  double reynolds = std::numeric_limits<double>::quiet_NaN();
  /// Size ratio and Stokes number, likewise.
  double size_ratio = std::numeric_limits<double>::quiet_NaN();
  double stokes = std::numeric_limits<double>::quiet_NaN();

  /// \throws std::invalid_argument if the law gives no such quantity
  [[nodiscard]] const LawValue& at(std::string_view name) const;
};

/// One law of the catalogue.
struct CatalogueEntry {
  LawInfo info;
  std::function<LawAnswer(const LawArguments& arguments)> evaluate;
  bool takes_transition;  ///< whether f of Ružička (2006) is a part of it
  std::vector<ParameterInfo> parameters = {};
  /// `evaluate` of the law with other values of its parameters. Throws as with_values.
  std::function<LawAnswer(const LawArguments& arguments)> (*with)(const LawCall& call) = nullptr;
};

/// The arguments that a law takes.
std::vector<const Argument*> arguments_of(const CatalogueEntry& law);

/// Every law of the suite, kind by kind.
const std::vector<CatalogueEntry>& catalogue();

/// The law of that name, "NAME" or "NAME:KEY=VALUE,KEY=VALUE", whose info.name has the parameters then.
/// \throws std::invalid_argument naming the unknown law and listing the known ones, or the parameters of the law
const CatalogueEntry& find_law(std::string_view text);

/// The laws that other sources print under the name of that law.
std::vector<const CatalogueEntry*> variants_of(std::string_view name);

/// One axis of a drawn family.
struct Axis {
  std::string_view title;  ///< with its unit in square brackets
  bool logarithmic = false;
  Range frame{};  ///< part of the axis that is drawn; with an open end, as much as the laws need
};

/// How a family of laws is drawn: one quantity of its answers along a line through the arguments.
struct Sweep {
  Axis x;
  double lower;
  double upper;
  LawArguments (*at)(LawArguments arguments, double x);  ///< the arguments with those of the x axis set
  Axis y;
  std::string_view quantity;  ///< name of the quantity on the y axis
};
const Sweep& sweep_of(LawKind kind);

/// Whether the voidage, the Reynolds number, the size ratio and the Stokes number lie in the ranges that the source
/// states.
bool in_range(const LawInfo& info, const LawArguments& arguments, const LawAnswer& evaluation);

std::string_view to_string(LawKind kind);
std::string_view to_string(Confidence confidence);

}  // namespace slfb
