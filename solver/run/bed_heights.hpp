#pragma once

#include <span>
#include <vector>

/// Heights of a bed from where its spheres are: of runs of this suite and of others alike.
namespace slfb::simulation {

struct BedHeights {
  double centre_of_mass = 0.0;  ///< Σ V z / Σ V, spheres of one density [m]
  double top = 0.0;             ///< 99th percentile of the heights of the centres [m]
};

/// \param heights of the centres [m] \param volumes of the spheres [m³]; neither is empty.
BedHeights bed_heights(std::vector<double> heights, std::span<const double> volumes);

struct SettledBed {
  double height = 0.0;   ///< twice the height of the centre of mass [m]
  double voidage = 0.0;  ///< 1 − V_s/(A h) of that height [-]
};

/// Of spheres that sink from the bottom up, of those that float from the lid down.
/// \param heights of the centres [m] \param volumes of the spheres [m³]
/// \param floats which of them rise; empty where none does
/// \param column_height [m] \param cross_section [m²]
SettledBed settled_bed(std::span<const double> heights, std::span<const double> volumes,
                       const std::vector<bool>& floats, double column_height, double cross_section);

}  // namespace slfb::simulation
