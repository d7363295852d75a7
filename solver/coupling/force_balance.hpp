#pragma once

#include <array>
#include <string_view>

#include "solver/scene/scene.hpp"

namespace slfb::coupling {

/// Forces along z, the column's axis, on spheres and liquid together [N], static head removed: they add up to zero.
///
/// Each term comes from where it arises: pressure, shear and flow from the liquid's equations, contacts with the bottom
/// and the other walls from the contact law, inertia from the momenta at both ends of the time. Drag and the pressure
/// force on the spheres are internal; that they do not appear shows that no impulse is lost between the phases.
struct ForceBalance {
  enum Term : std::size_t {
    pressure,        ///< Δp A
    buoyant_weight,  ///< Σ (m − ρ V) g_z
    bottom,          ///< contacts with the distributor
    walls,           ///< contacts with the side walls and a lid
    shear,           ///< of the liquid at the walls, and viscous stress at the ends
    flow,            ///< momentum that comes in less what goes out with the liquid
    sphere_inertia,  ///< −d(Σ m v)/dt, with what an added mass has on its way to the liquid
    liquid_inertia,  ///< −d(Σ ρ V_L w)/dt, as the time scheme forms it
    terms
  };
  std::array<double, terms> force{};

  [[nodiscard]] double residual() const {
    double sum = 0.0;
    for (const double f : force) sum += f;
    return sum;
  }
};

/// Why the forces of a scene do not add up to zero in each step, in words for its user; empty if they do (to 1e-6 of
/// the spheres' buoyant weight; with SIMPLE to some times fluid.simple_tolerance).
///
/// One choice does that. In second order the projection convects momentum with a flow that is extrapolated from the two
/// steps before. That flow is not the one that fills the cells of this step, and momentum is gained or lost by their
/// difference, of second order in the step. SIMPLE iterates until both are one, and in a section of a single cell the
/// flow is known beforehand.
inline std::string_view imbalance_of_forces(const Scene& scene) {
  const bool extrapolates = scene.fluid.tier == FluidTier::three_dimensional &&
                            scene.fluid.time_scheme == TimeScheme::second_order &&
                            scene.fluid.pressure_velocity == PressureVelocity::projection;
  return extrapolates ? "with fluid.time_scheme = \"second-order\" and the projection the liquid's momentum is kept to "
                        "second order in fluid.time_step only, since it is convected with an extrapolated flow; forces "
                        "then add up to about a hundredth of the weight in a step (bed/balance_residual), and to "
                        "round-off with \"simple\" or \"euler\""
                      : "";
}

}  // namespace slfb::coupling
