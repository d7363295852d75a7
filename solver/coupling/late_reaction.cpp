#include "solver/coupling/late_reaction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slfb::coupling {

double least_density_ratio(const Scene& scene, double voidage) {
  if (scene.fluid.tier == FluidTier::quiescent) return 0.0;
  const double s = (1.0 - voidage) / voidage, c = scene.coupling.added_mass;
  const double steps = std::max(1.0, std::round(scene.coupling.void_fraction_interval / scene.fluid.time_step));
  const double of_interval = 3.0 - 2.0 / steps;
  const double of_scheme = scene.fluid.time_scheme == TimeScheme::second_order ? 4.0 : 1.0;
  const double factor = std::max(of_interval, of_scheme);
  if (factor > 1.0 || c == 0.0) return factor * s;
  return std::max({0.0, s - c * (1.0 + s * s), c * (s + s * s - 1.0)});
}

double density_ratio_of_bed(const Scene& scene) {
  double least = std::numeric_limits<double>::infinity();
  for (const Species& species : scene.species)
    if (species.count > 0) least = std::min(least, species.density / scene.liquid.density);
  return least;
}

}  // namespace slfb::coupling
