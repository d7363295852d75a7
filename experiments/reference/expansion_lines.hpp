#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "correlations/materials.hpp"

/// Measured lines of beds and suspensions, and measured packed beds: reference-data/README.md has the format.
namespace slfb {

/// How the spheres of a line and the liquid move.
enum class BedMotion {
  fluidised,  ///< liquid flows up through spheres that stand still on average
  settling,   ///< spheres settle through liquid that is at rest on average
};

/// A measured line U = U_i ε^n of one kind of sphere in one liquid and one tube.
///
/// U is the superficial velocity of a fluidised bed, or the velocity at which the boundary of a suspension falls: both
/// are the slip velocity of liquid and spheres times the voidage.
struct ExpansionLine {
  std::string work;      ///< folder in reference-data/
  std::string name;      ///< unique in its file
  std::string particle;  ///< in words
  std::string liquid_name;
  BedMotion motion;
  Sphere sphere;
  LiquidProperties liquid;
  double tube_diameter;  ///< D [m]
  double intercept;      ///< U_i [m/s]
  double exponent;       ///< n [-]
  std::string remark;    ///< what is doubtful about it

  /// Lines of the same spheres in the same liquid: they share the errors of diameter, density and viscosity.
  [[nodiscard]] std::string group() const;
  /// U [m/s] at a voidage.
  [[nodiscard]] double velocity(double voidage) const;
  [[nodiscard]] double diameter_ratio() const { return sphere.diameter / tube_diameter; }  ///< d/D [-]
};

/// Largest rounding of the printed logarithm of U_i and of n: half of their last digit.
inline constexpr double line_rounding = 0.005;

/// The lines of a folder of reference-data/ (fluidised_lines.csv, settling_lines.csv), in their order; none where it
/// has no such file. Throws std::runtime_error with file and line on anything unexpected.
std::vector<ExpansionLine> expansion_lines(const std::filesystem::path& folder);

/// A measured pressure drop through a packed bed.
struct PackedBedPoint {
  std::string series;           ///< who measured it
  double reynolds_over_solids;  ///< Re/(1 − ε), Re = ρ U d / μ [-]
  double viscous_friction;      ///< Δp d² ε³ / (L μ U (1 − ε)²) [-]
};

/// The points of a folder of reference-data/ (packed_beds.csv); none where it has no such file. Throws as the other.
std::vector<PackedBedPoint> packed_bed_points(const std::filesystem::path& folder);

/// The folders of reference-data/, by name.
std::vector<std::filesystem::path> reference_data_folders();

}  // namespace slfb
