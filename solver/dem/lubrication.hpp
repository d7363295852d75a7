#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slfb::dem {

/// Force of the liquid that is squeezed out between two nearly touching spheres, or a sphere and a wall:
/// F = −6 π μ R² v (1/h − 1/h_outer) along the line of centres, R = r_1 r_2/(r_1 + r_2) (Nguyen & Ladd 2002, Phys. Rev.
/// E 66, 046708; ten Cate et al. 2002).
///
/// For two equal spheres this is 3/2 π μ r² v/h, for a wall (R = r) 6 π μ r² v/h. The subtracted 1/h_outer lets it
/// begin without a step where the resolved flow, or the drag law, stops carrying the squeezing. Below h_inner, the
/// height of the roughness, the gap counts as h_inner: smooth spheres would never touch. Keys: nguyen2002, brenner1961.
/// Range: Stokes flow in the gap, ρ v h/μ ≪ 1, h ≪ R: the first neglected term is (R/5) ln(R/h) beside R²/h at a wall.
class Lubrication {
 public:
  /// \param inner_gap h_inner [m], > 0: 1e-3 to 1e-2 radii for ground glass; \param outer_gap h_outer [m], > h_inner
  Lubrication(double viscosity, double inner_gap, double outer_gap)
      : factor_(6.0 * std::numbers::pi * viscosity), inner_gap_(inner_gap), outer_gap_(outer_gap) {}

  [[nodiscard]] double outer_gap() const { return outer_gap_; }

  /// F/−v [N s/m]: what the force is linear in, for a step implicit in the velocities.
  /// \param gap h between the surfaces, negative where the spheres overlap [m]
  [[nodiscard]] double coefficient(double gap, double reduced_radius) const {
    if (gap >= outer_gap_) return 0.0;
    return factor_ * reduced_radius * reduced_radius * (1.0 / std::max(gap, inner_gap_) - 1.0 / outer_gap_);
  }

  /// Force that drives the two apart [N]; negative, holding them together, while they part.
  /// \param approach rate at which the gap closes [m/s]
  [[nodiscard]] double repulsion(double gap, double reduced_radius, double approach) const {
    return coefficient(gap, reduced_radius) * approach;
  }

 private:
  double factor_, inner_gap_, outer_gap_;
};

/// r_1 r_2/(r_1 + r_2) [m]; against a wall the sphere's own radius.
constexpr double reduced_radius(double first, double second) { return first * second / (first + second); }

/// Drag over Stokes drag of a sphere that moves straight to or from a wall, exact series of Brenner (1961), Chem. Eng.
/// Sci. 16, 242: λ = (4/3) sinh α Σ n(n + 1)/((2n − 1)(2n + 3)) [(2 sinh(2n + 1)α + (2n + 1) sinh 2α)/
/// (4 sinh²(n + ½)α − (2n + 1)² sinh²α) − 1], cosh α = 1 + h/r.
///
/// Key: brenner1961. Range: Stokes flow; every gap, with some 10 √(r/h) terms.
/// \param relative_gap h/r [-], > 0
inline double brenner_wall_drag(double relative_gap) {
  const double alpha = std::acosh(1.0 + relative_gap), sinh_alpha = std::sinh(alpha);
  double sum = 0.0, term = 1.0;
  for (double n = 1.0; term > std::numeric_limits<double>::epsilon() * sum && (2.0 * n + 1.0) * alpha < 300.0; ++n) {
    const double k = 2.0 * n + 1.0, half = std::sinh(0.5 * k * alpha);
    const double quotient = (2.0 * std::sinh(k * alpha) + k * std::sinh(2.0 * alpha)) /
                            (4.0 * half * half - k * k * sinh_alpha * sinh_alpha);
    term = n * (n + 1.0) / ((2.0 * n - 1.0) * (2.0 * n + 3.0)) * (quotient - 1.0);
    sum += term;
  }
  return 4.0 / 3.0 * sinh_alpha * sum;
}

}  // namespace slfb::dem
