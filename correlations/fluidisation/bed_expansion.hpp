#pragma once

#include <algorithm>
#include <cmath>

#include "correlations/drag/drag_law.hpp"
#include "correlations/materials.hpp"
#include "correlations/root.hpp"

namespace slfb::fluidisation {

/// How a homogeneous bed answers a superficial velocity.
enum class BedRegime {
  packed,      ///< the drag does not lift the packed bed
  expanded,    ///< a voidage exists at which the drag balances the weight
  at_jump,     ///< the law jumps over the balance: no steady voidage, the bed sticks at the jump
  washed_out,  ///< the drag exceeds the weight even of a sphere alone
};

/// Voidage of a homogeneous bed and how it came about.
struct BedState {
  double voidage;  ///< ε [-]
  BedRegime regime;
};

/// Drag over buoyant weight of the spheres of a homogeneous bed [-]: F Re / ε over Ar / 18. It is 1 in equilibrium.
/// \param law a drag law of the suite
/// \param reynolds Re = ρ U d / μ on the superficial velocity U [-]
template <class Law>
double drag_over_buoyant_weight(const Law& law, double voidage, double reynolds, double archimedes) {
  return 18.0 * law(drag::SuspensionFlow{voidage, reynolds}) * reynolds / (voidage * archimedes);
}

/// Superficial velocity U [m/s] at which a homogeneous bed of the given voidage is in equilibrium, found with GSL.
/// \throws std::domain_error if the law has no solution there
template <class Law>
double superficial_velocity(const Law& law, Sphere sphere, LiquidProperties liquid, double voidage) {
  const double archimedes = archimedes_number(sphere, liquid);
  auto excess = [&](double re) { return drag_over_buoyant_weight(law, voidage, re, archimedes) - 1.0; };
  double upper = 1.0;
  while (excess(upper) < 0.0 && upper < 1e12) upper *= 2.0;
  const double reynolds = bracketed_root(excess, 0.0, upper, "Reynolds number of the bed [-]");
  return reynolds * liquid.viscosity / (liquid.density * sphere.diameter);
}

/// Minimum fluidisation velocity [m/s] of any drag law: the velocity that just carries the bed at its packed voidage.
template <class Law>
double minimum_fluidisation_velocity(const Law& law, Sphere sphere, LiquidProperties liquid, double packed_voidage) {
  return superficial_velocity(law, sphere, liquid, packed_voidage);
}

/// Voidage of a homogeneous bed at superficial velocity U [m/s], found with GSL.
/// \param packed_voidage smallest voidage the bed can take [-]
template <class Law>
BedState bed_voidage(const Law& law, Sphere sphere, LiquidProperties liquid, double velocity, double packed_voidage) {
  const double archimedes = archimedes_number(sphere, liquid);
  const double reynolds = reynolds_number(liquid, sphere.diameter, velocity);
  auto excess = [&](double e) { return drag_over_buoyant_weight(law, e, reynolds, archimedes) - 1.0; };
  if (excess(packed_voidage) <= 0.0) return {packed_voidage, BedRegime::packed};
  if (excess(1.0) >= 0.0) return {1.0, BedRegime::washed_out};
  const double voidage = bracketed_root(excess, packed_voidage, 1.0, "voidage [-]");
  // Across a root the excess is small on both sides; across a jump it is not.
  constexpr double step = 1e-9;
  const double gap = std::max(std::abs(excess(voidage - step)), std::abs(excess(voidage + step)));
  return {voidage, gap > 1e-6 ? BedRegime::at_jump : BedRegime::expanded};
}

}  // namespace slfb::fluidisation
