#pragma once

#include <array>

namespace slfb::coupling {

/// Forces along z on spheres and liquid together [N], static head removed: they add up to zero.
///
/// Each term comes from where it arises: pressure, shear and flow from the liquid's equations, contacts with the bottom
/// and the other walls from the contact law, inertia from the momenta at both ends of the time. Drag and the pressure
/// force on the spheres are internal; that they do not appear shows that no impulse is lost between the phases.
struct ForceBalance {
  enum Term : std::size_t {
    pressure,        ///< Δp A
    buoyant_weight,  ///< −Σ (m − ρ V) g
    bottom,          ///< contacts with the distributor
    walls,           ///< contacts with the side walls and a lid
    shear,           ///< of the liquid at the walls, and viscous stress at the ends
    flow,            ///< momentum that comes in less what goes out with the liquid
    sphere_inertia,  ///< −d(Σ m v)/dt
    liquid_inertia,  ///< −d(Σ ρ V_L w)/dt
    terms
  };
  std::array<double, terms> force{};

  [[nodiscard]] double residual() const {
    double sum = 0.0;
    for (const double f : force) sum += f;
    return sum;
  }
};

}  // namespace slfb::coupling
