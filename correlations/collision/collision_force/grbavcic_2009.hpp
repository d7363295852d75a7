#pragma once

#include <cmath>
#include <numbers>

#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "correlations/foreign_sphere.hpp"
#include "correlations/law.hpp"

namespace slfb::collision {

/// A force over weight known only to lie between two values.
struct ForceBand {
  double lower;  ///< F_c/(m g) [-]
  double upper;  ///< F_c/(m g) [-]
};

/// Whose diameter and terminal velocity stand in Eq. 14; the source leaves it open.
enum class DisplacedDrag { of_foreign_sphere, of_bed_spheres };

/// Mean collision force on a foreign sphere over its weight after Grbavčić et al. (2009), Powder Technol. 190, 283;
/// Eqs. 13–15 of Peng 2014:
/// \f$ F_c = k (1 - f) N\,\tfrac12 \rho\,\tfrac{\pi}{4} d_p^2 U_\infty^2 \f$, \f$ N = \alpha_S (d_2/d_1)^3 \f$,
/// \f$ k = 2.2\,\varepsilon^{5.07} (d_2/d_1)^{-1.48} (\rho_M/\rho_{eff})^{2.47} \f$,
/// \f$ \rho_{eff} = (1 - f) \rho + f \rho_M \f$.
///
/// The transition function f of Ružička (2006) is not at hand. It lies between 0 (buoyancy of the liquid) and 1 (of the
/// suspension), and the law is evaluated as a band over f = 0…1. Confidence: derived; +5.07 is firm, −1.48 likely,
/// +2.47 weak.
template <DisplacedDrag reading>
struct Grbavcic2009 {
  static constexpr bool foreign = reading == DisplacedDrag::of_foreign_sphere;
  static constexpr LawInfo info{
      .name = foreign ? "grbavcic-2009-force" : "grbavcic-2009-force-bed",
      .kind = LawKind::collision_force,
      .title = foreign ? "Collision force on a foreign sphere, Grbavcic et al. (2009), Eq. 14 with the foreign sphere"
                       : "Collision force on a foreign sphere, Grbavcic et al. (2009), Eq. 14 with the bed spheres",
      .equation =
          "F_c/(m g) = k (1 - f) N rho (pi/8) dp^2 U_inf^2/(m g), N = a (d2/d1)^3, "
          "k = 2.2 e^5.07 (d2/d1)^-1.48 (rho_M/rho_eff)^2.47",
      .equation_number = "Peng 2014, Eqs. 13-15",
      .source = "grbavcic2009",
      .convention = foreign ? "a = 1 - e; dp and U_inf are those of the foreign sphere"
                            : "a = 1 - e; dp and U_inf are those of the bed spheres",
      .reynolds = {0.0, std::numeric_limits<double>::infinity()},
      .voidage = {0.4, 1.0},
      .confidence = Confidence::derived,
      .note = "a band over f = 0 to 1: the transition function of Ruzicka (2006) was not at hand"};

  double transition = 0.5;  ///< f [-], 0…1

  /// ρ_eff = (1 − f) ρ + f ρ_M [kg/m³], whose weight the foreign sphere loses.
  [[nodiscard]] double effective_density(const ForeignSphereInBed& state) const {
    return (1.0 - transition) * state.liquid.density + transition * state.mixture_density();
  }

  /// \return F_c/(m g) [-]; the settling velocity has no part in it
  double operator()(const ForeignSphereInBed& state, double /*settling_velocity*/ = 0.0) const {
    const Sphere& sphere = foreign ? state.foreign : state.bed;
    const double size_ratio = state.foreign.diameter / state.bed.diameter;
    const double displaced = state.solids() * size_ratio * size_ratio * size_ratio;  // Eq. 13
    const double k = 2.2 * std::pow(state.voidage, 5.07) * std::pow(size_ratio, -1.48) *
                     std::pow(state.mixture_density() / effective_density(state), 2.47);  // Eq. 15
    const double terminal =
        fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, sphere, state.liquid);
    const double dynamic_force =
        std::numbers::pi / 8.0 * state.liquid.density * sphere.diameter * sphere.diameter * terminal * terminal;
    return k * (1.0 - transition) * displaced * dynamic_force / state.foreign.weight();  // Eq. 14
  }

  /// The force over f = 0…1. It falls steadily with f, to zero at f = 1.
  static ForceBand band(const ForeignSphereInBed& state) {
    return {Grbavcic2009{.transition = 1.0}(state), Grbavcic2009{.transition = 0.0}(state)};
  }
};

}  // namespace slfb::collision
