#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "solver/dem/linear_spring_dashpot.hpp"

namespace slfb::dem {

/// Elastic spheres: Hertz (1882) normally, Mindlin's (1949) no-slip stiffness tangentially, damped for a constant e.
///
/// F_n = 4/3 E* √(R* δ) δ + c_n δ', c_n = 2 √(5/6) ζ √(S_n m_eff), S_n = 2 E* √(R* δ); k_t = 8 G* √(R* δ),
/// c_t = 2 √(5/6) ζ √(k_t m_eff). With damping as δ^{1/4} the restitution does not depend on the impact speed, and this
/// factor makes it e exactly (Tsuji et al. 1992, Powder Technol. 71:239; Antypov & Elliott 2011, EPL 94:50004). The
/// tangential force is k_t(δ) ξ: on unloading the spring loses stiffness with its energy, so a full tangential
/// cycle is not free of artificial work; the steps of Mindlin & Deresiewicz (1953) are not followed. With E_i and ν_i
/// of the two bodies 1/E* = Σ (1 − ν_i²)/E_i and 1/G* = Σ 2 (1 + ν_i)(2 − ν_i)/E_i.
class HertzMindlin {
 public:
  static constexpr std::array keys{ContactKey{"youngs_modulus", true}, ContactKey{"poisson_ratio"},
                                   ContactKey{"rigid_walls"}, ContactKey{"restitution"}, ContactKey{"cut_tension"}};
  static constexpr ContactLawInfo info{
      .name = "hertz",
      .title = "Elastic spheres with a constant restitution, Hertz (1882), Mindlin (1949), Tsuji et al. (1992)",
      .equation = "F_n = 4/3 E* sqrt(R* d) d + c_n d', c_n = 2 sqrt(5/6) zeta sqrt(S_n m_eff), S_n = 2 E* sqrt(R* d)",
      .source = "tsuji1992",
      // Hertz's half-spaces: the radius of the contact, sqrt(R* d), at most a tenth of R*.
      .overlap = {0.0, 0.01},
      .keys = keys,
      .stiffness_key = "youngs_modulus"};

  /// With `at_wall` the second body is the wall, with contact.rigid_walls one that does not deform.
  explicit HertzMindlin(const Contact& contact, bool at_wall = false) {
    const double bodies = at_wall && contact.rigid_walls ? 1.0 : 2.0;
    const double poisson = contact.poisson_ratio;
    effective_modulus_ = contact.youngs_modulus / (bodies * (1.0 - poisson * poisson));
    effective_shear_modulus_ = contact.youngs_modulus / (bodies * 2.0 * (1.0 + poisson) * (2.0 - poisson));
    if (at_wall && !contact.rigid_walls && (contact.wall.youngs_modulus || contact.wall.poisson_ratio)) {
      const double wall_modulus = contact.wall.youngs_modulus.value_or(contact.youngs_modulus);
      const double wall_poisson = contact.wall.poisson_ratio.value_or(poisson);
      effective_modulus_ = 1.0 / ((1.0 - poisson * poisson) / contact.youngs_modulus +
                                  (1.0 - wall_poisson * wall_poisson) / wall_modulus);
      effective_shear_modulus_ = 1.0 / (2.0 * (1.0 + poisson) * (2.0 - poisson) / contact.youngs_modulus +
                                        2.0 * (1.0 + wall_poisson) * (2.0 - wall_poisson) / wall_modulus);
    }
    damping_ = 2.0 * std::sqrt(5.0 / 6.0) * damping_ratio(contact.restitution);
    time_step_ = contact.time_step;
    steps_per_second_ = 1.0 / contact.time_step;
    lag_ = contact.integrator == Integrator::symplectic_euler ? 0.5 * contact.time_step : 0.0;
    least_force_ = contact.cut_tension ? 0.0 : -std::numeric_limits<double>::infinity();
  }

  /// `overlap` δ > 0 [m], `approach` δ' [m/s], `root_effective_mass` √m_eff [kg^½], `effective_radius` R* [m].
  [[gnu::always_inline]] NormalContact operator()(double overlap, double approach, double root_effective_mass,
                                                  double effective_radius) const {
    const double contact_radius = std::sqrt(effective_radius * overlap);
    const double stiffness = 2.0 * effective_modulus_ * contact_radius;
    const double tangential_stiffness = 8.0 * effective_shear_modulus_ * contact_radius;
    const double factor = damping_ * root_effective_mass;
    const double damping = factor * std::sqrt(stiffness);
    const double ahead = root_effective_mass / (root_effective_mass + lag_ * damping_ * std::sqrt(stiffness));
    const double load = ahead * (2.0 / 3.0 * stiffness * overlap + damping * approach);
    const double force =
        load + ahead * damping * dashpot_end_correction(overlap, approach, time_step_, steps_per_second_, 1.3278);
    return {force > least_force_ ? force : least_force_, load > least_force_ ? load : least_force_, stiffness,
            tangential_stiffness, factor * std::sqrt(tangential_stiffness)};
  }

  /// Duration of an elastic collision, 2.8683 (m_eff²/(R* E*² v))^{1/5} (Landau & Lifshitz, Theory of Elasticity, §9)
  /// [s].
  static double contact_time(double effective_modulus, double effective_radius, double effective_mass, double speed) {
    return 2.8683 * std::pow(effective_mass * effective_mass /
                                 (effective_radius * effective_modulus * effective_modulus * speed),
                             0.2);
  }

 private:
  double effective_modulus_, effective_shear_modulus_, damping_, time_step_, steps_per_second_, lag_, least_force_;
};

}  // namespace slfb::dem
