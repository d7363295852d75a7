#pragma once

#include <cmath>

#include "correlations/law.hpp"

namespace slfb::drag::single_sphere {

/// Drag of a single sphere after Abraham (1970), Phys. Fluids 13, 2194, from the boundary layer around it:
/// \f$ C_D = \frac{24}{9.06^2}\,(1 + 9.06/\sqrt{Re})^2 \f$.
///
/// Range: Re < 5000. Confidence: recalled; it reproduces the four terminal velocities that ten Cate et al. (2002)
/// state.
struct Abraham1970 {
  static constexpr LawInfo info{
      .name = "abraham-1970",
      .kind = LawKind::single_sphere_drag,
      .title = "Drag of a single sphere, Abraham (1970)",
      .equation = "C_D = 24/9.06^2 (1 + 9.06/sqrt(Re))^2",
      .source = "abraham1970",
      .convention = "Re = rho d w / mu on the slip velocity w of the sphere in unbounded liquid",
      .reynolds = {0.0, 5e3},
      .voidage = {1.0, 1.0},
      .confidence = Confidence::recalled};

  /// \param reynolds Re [-], ≥ 0
  /// \return drag over Stokes drag, C_D Re / 24 [-]; 1 at Re = 0
  template <class Number>
  Number operator()(Number reynolds) const {
    using std::sqrt;
    const Number root = 1.0 + sqrt(reynolds) / 9.06;
    return root * root;
  }
};

}  // namespace slfb::drag::single_sphere
