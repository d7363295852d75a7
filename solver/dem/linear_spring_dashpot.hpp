#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/dem/contact_law_info.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::dem {

/// What the weight of the dashpot at the first and last two samples of a contact adds to its approach speed [m/s].
///
/// A sample stands for the half steps around it. Counted so, a dashpot whose force jumps to c_n δ' where the spheres
/// meet would act for up to half a step too long or too short at either end of a contact, which leaves an error of the
/// restitution of first order, with the phase of the contact in the steps. The weights of the samples at
/// s = δ/(Δt |δ'|) < 1 and s + 1, b s and b − (b − 1) s, make that sum the integral at both ends of the phase, and for
/// a constant dashpot (b = 3/2) at every phase; that they are continuous keeps the last step from mattering. With a
/// dashpot as δ^{1/4} b = 4/5 (3/2)^{5/4}. Computed as distances, times Δt |δ'|, which needs no division.
[[gnu::always_inline]] inline double dashpot_end_correction(double overlap, double approach, double time_step,
                                                            double steps_per_second, double b) {
  const double way = time_step * std::abs(approach);
  const double falling = (2.0 * b - 1.0) * way - (b - 1.0) * overlap, rising = b * overlap;
  const double late = falling > way ? falling : way;
  return std::copysign(steps_per_second, approach) * ((rising < late ? rising : late) - way);
}

/// Result of a normal law for a touching pair, which friction and rolling resistance go on from.
struct NormalContact {
  double force;                 ///< compressive positive [N]
  double load;                  ///< the same without dashpot_end_correction(): what friction goes by [N]
  double stiffness;             ///< ∂F_n/∂δ of the elastic part [N/m]
  double tangential_stiffness;  ///< k_t [N/m]
  double tangential_damping;    ///< c_t [N s/m]
};

/// ζ = −ln e/√(π² + ln² e): the damping ratio with which a half period of an oscillator returns e times its speed [-].
inline double damping_ratio(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::sqrt(std::numbers::pi * std::numbers::pi + log_e * log_e);
}

/// Linear spring and dashpot (Cundall & Strack 1979; Tsuji et al. 1993; Peng 2014, §3.1).
///
/// F_n = k_n δ + c_n δ', c_n = 2 ζ √(k_n m_eff): a damped oscillator, whose half period π/(ω_0 √(1 − ζ²)) returns e
/// times the impact speed. Just before the spheres part the force pulls. Cutting that tension off
/// (`contact.cut_tension`) ends the push earlier in time and raises the restitution above e: to
/// exp(−ζ/√(1 − ζ²) (π − arctan(2ζ√(1 − ζ²)/(2ζ² − 1)))) for ζ < 1/√2 (Schwager & Pöschel 2007, Granular Matter
/// 9:465).
///
/// Along the contact plane (contact.tangential_model): k_t = tangential_stiffness_ratio k_n and c_t =
/// tangential_damping_ratio c_n, limited by Coulomb friction; or the dashpot alone, |F_t| = min(c_t |v_t|, μ F_n),
/// which remembers nothing and so holds no sphere on a slope; or the spring alone, which loses energy by sliding only.
class LinearSpringDashpot {
 public:
  static constexpr std::array keys{ContactKey{"stiffness", true},
                                   ContactKey{"restitution"},
                                   ContactKey{"cut_tension"},
                                   ContactKey{"tangential_stiffness_ratio"},
                                   ContactKey{"tangential_damping_ratio"},
                                   ContactKey{"tangential_model"}};
  static constexpr ContactLawInfo info{.name = "linear",
                                       .title = "Linear spring and dashpot, Cundall & Strack (1979)",
                                       .equation = "F_n = k_n d + c_n d', c_n = 2 zeta sqrt(k_n m_eff)",
                                       .source = "cundall1979",
                                       .overlap = {},
                                       .keys = keys,
                                       .stiffness_key = "stiffness"};

  explicit LinearSpringDashpot(const Contact& contact, bool /*at_wall*/ = false)
      : stiffness_(contact.stiffness),
        damping_(2.0 * damping_ratio(contact.restitution) * std::sqrt(contact.stiffness)),
        tangential_stiffness_(contact.tangential_model == TangentialModel::dashpot
                                  ? 0.0
                                  : contact.stiffness * contact.tangential_stiffness_ratio),
        tangential_damping_ratio_(
            contact.tangential_model == TangentialModel::spring ? 0.0 : contact.tangential_damping_ratio),
        time_step_(contact.time_step),
        steps_per_second_(1.0 / contact.time_step),
        lag_(contact.integrator == Integrator::symplectic_euler ? 0.5 * contact.time_step : 0.0),
        least_force_(contact.cut_tension ? 0.0 : -std::numeric_limits<double>::infinity()) {}

  /// `overlap` δ > 0 [m], `approach` δ' [m/s], `root_effective_mass` √m_eff [kg^½], `effective_radius` [m] (not used).
  [[gnu::always_inline]] NormalContact operator()(double overlap, double approach, double root_effective_mass,
                                                  double /*effective_radius*/) const {
    const double damping = damping_ * root_effective_mass;
    // Symplectic Euler knows the velocity of half a step ago; this is the force at that of now.
    const double ahead = root_effective_mass / (root_effective_mass + lag_ * damping_);
    const double load = ahead * (stiffness_ * overlap + damping * approach);
    const double force =
        load + ahead * damping * dashpot_end_correction(overlap, approach, time_step_, steps_per_second_, 1.5);
    return {force > least_force_ ? force : least_force_, load > least_force_ ? load : least_force_, stiffness_,
            tangential_stiffness_, tangential_damping_ratio_ * damping};
  }

  /// Duration of a collision, π/(ω_0 √(1 − ζ²)) [s].
  static double contact_time(double stiffness, double restitution, double effective_mass) {
    const double zeta = damping_ratio(restitution);
    return std::numbers::pi / std::sqrt(stiffness / effective_mass * (1.0 - zeta * zeta));
  }

  /// Restitution that is left when the tension is cut off (Schwager & Pöschel 2007, Eq. 21) [-].
  static double restitution_without_tension(double restitution) {
    const double zeta = damping_ratio(restitution), root = std::sqrt(1.0 - zeta * zeta);
    // The force vanishes at the angle 2 arccos ζ... of the oscillation, before the overlap does at π.
    const double angle = std::numbers::pi - std::atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta);
    return std::exp(-zeta / root * angle);
  }

 private:
  double stiffness_, damping_, tangential_stiffness_, tangential_damping_ratio_, time_step_, steps_per_second_, lag_,
      least_force_;
};

}  // namespace slfb::dem
