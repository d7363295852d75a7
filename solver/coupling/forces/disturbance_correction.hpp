#pragma once

#include <span>

#include "correlations/materials.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// Σ_c φ_c²/V_c [1/m³]: one over the volume V_e that a sphere's shares spread a force over, and gather from.
/// \param shares φ_c of the sphere [-], adding up to one; \param cell_volumes V_c of the same cells [m³]
double share_concentration(std::span<const double> shares, std::span<const double> cell_volumes);

/// Voidage that a sphere would see if it were not there itself [-].
///
/// Gathered through its shares the solid fraction is s = s_others + s_own, s_own = V Σ φ²/V_c. A sphere keeps others
/// away: in a large volume E[s_others] = s̄ − (1 − S_0) s_own with the compressibility S_0(s̄) = ⟨ΔN²⟩/⟨N⟩ of the
/// suspension, so that s̄ = s − S_0 s_own. Alone (S_0 = 1) all of its own volume goes, in a dense suspension (S_0 → 0)
/// nothing: there it stands in the place of a neighbour. S_0 is that of Carnahan & Starling (1969), J. Chem. Phys. 51,
/// 635, (1 − s)⁴/((1 + 2s)² + s³(s − 4)), taken at what the others fill of the room that is left to them,
/// s_others/(1 − s_own).
///
/// Key: carnahan1969. Range: hard spheres in disorder, cells of 1.2 diameters and more. In smaller ones shares see the
/// inside of the sphere more and more, and the result tends to 1 in any suspension; without the correction to 0.
/// \param voidage 1 − s, gathered through the sphere's shares from the voidage of the cells [-]
/// \param own_fraction s_own [-]
double undisturbed_voidage(double voidage, double own_fraction);

/// Steady velocity that a force gives the liquid where the sphere gathers it, over that of Stokes flow, Ψ(R) [-].
///
/// The Oseen solution for a force with the weight of a Gaussian of width σ in liquid that passes along it, gathered at
/// its centre: Ψ = (3/2) ∫_0^1 (1 − c²)(1 − √(π/2) x e^(x²/2) erfc(x/√2)) dc, x = R c, R = ρ w σ/μ, done in closed
/// form. Ψ → 1 − (3/8) √(π/2) R (Oseen's drag) and → (3/2) √(π/2)/R (a wake without viscosity). Key: balachandar2019,
/// whose model this is the Oseen solution of.
double oseen_weakening(double width_reynolds);

/// What one sphere's force on the liquid does to the liquid velocity that the sphere itself gathers.
///
/// After Balachandar, Liu & Lakhote (2019), J. Comput. Phys. 376, 160 (steady, and Ψ) and Horwitz & Mani (2016), J.
/// Comput. Phys. 318, 85 (that the grid's own Green's function decides): u_self = c F Ψ/(α μ V_e^(1/3)), V_e = 1/Σ
/// φ²/V_c. It is reached as du/dt = (u_self − u)/τ with τ = c Ψ ρ V_e^(2/3)/(a μ), so that it begins with the inertia
/// of the liquid that is set in motion, du/dt = a F/(α ρ V_e). c = 0.115 and a = 0.5 are those of the staggered grid
/// with forces halved onto the faces and velocities averaged from them, means over sphere positions of the exact
/// discrete solution, which scatters by ±20 % and ±25 % around them; σ = √(2/π)/(6 π c) V_e^(1/3) is the Gaussian of
/// the same c.
///
/// Undisturbed slip = gathered u − u_self − v. Keys: balachandar2019, horwitz2016. Range: cells of 0.7 diameters and
/// more, away from walls, force along the slip (Ψ), a grid Reynolds number ρ w V_e^(1/3)/μ to 100; a single sphere's
/// disturbance, not screened by neighbours, and so too large in a dense bed.
class SelfInducedVelocity {
 public:
  explicit SelfInducedVelocity(LiquidProperties liquid) : liquid_(liquid) {}

  /// Steady u_self/F [s/kg].
  /// \param concentration share_concentration() [1/m³]; \param voidage of the cells it acts in [-]
  /// \param slip speed of the undisturbed liquid against the sphere [m/s]
  [[nodiscard]] double mobility(double concentration, double voidage, double slip) const;

  /// u_self at the end of a step [m/s]. \param previous at its beginning [m/s]
  /// \param force of the sphere on the liquid over the step [N]
  [[nodiscard]] Vec3 advance(Vec3 previous, Vec3 force, double concentration, double voidage, double slip,
                             double time_step) const;

 private:
  LiquidProperties liquid_;
};

}  // namespace slfb::coupling
