#pragma once

#include <string>
#include <vector>

#include "experiments/numerics/studies/hard_spheres.hpp"
#include "solver/scene/scene.hpp"

/// What the schemes that share a sphere's volume among cells make of the same spheres. Lengths in sphere diameters.
namespace slfb::void_fraction_study {

struct Method {
  std::string name;
  VoidFractionScheme scheme;
  int pieces;        ///< particle meshing only
  double smoothing;  ///< bandwidth of the diffusion; 0: none [diameters]
};

/// Centroid, particle meshing from coarse to fine, exact overlap, and what diffusion makes of the first and the last.
const std::vector<Method>& methods();

struct Outcome {
  double root_mean_square, largest;  ///< difference of a cell's solids fraction from exact overlap, over its mean [-]
  double nanoseconds;                ///< CPU time per sphere: shares, sums over the cells, smoothing of one field
};

/// The methods `candidates` on cubic cells, `across` of them over the assembly.
/// \param placements of the grid on the assembly, over which errors are taken together
/// \param timed CPU time to spend on repeating each method, of which the shortest run counts [s]; 0: one run
std::vector<Outcome> compare(const Assembly& assembly, int across, int placements, double timed,
                             const std::vector<Method>& candidates);

/// Part of a sphere's volume in a cell of width `cell`, for each of `distances` of its centre beyond the middle of the
/// cell's face; the sphere is centred across the face.
/// \param cell, distances in diameters
/// \return parts of the volume [-]
std::vector<double> crossing(const Method& method, double cell, const std::vector<double>& distances);

}  // namespace slfb::void_fraction_study
