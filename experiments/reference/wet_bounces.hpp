#pragma once

#include <vector>

/// What is measured of spheres that bounce in a liquid; the source.toml of each folder says how sure it is.
namespace slfb {

/// A measured bounce of a sphere on a wall in a liquid.
struct WetBounce {
  double stokes = 0.0;       ///< ρ_P U d/(9 μ) [-]
  double restitution = 0.0;  ///< speed after over speed before [-]
};
/// Gondret, Lance & Petit (2002), two bounces, from reference-data/gondret_2002.
std::vector<WetBounce> gondret_2002();

/// Joseph et al. (2001): no rebound below the first Stokes number, the dry restitution above the second [-].
struct StokesLimits {
  double no_rebound_below = 0.0, dry_above = 0.0;
};
/// From reference-data/joseph_2001.
StokesLimits joseph_2001();

}  // namespace slfb
