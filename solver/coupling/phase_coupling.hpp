#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "solver/coupling/void_fraction.hpp"
#include "solver/dem/engine.hpp"
#include "solver/fluid/liquid_solver.hpp"

namespace slfb::coupling {

/// Two-way momentum exchange between spheres and liquid over one liquid step (Peng 2014, Eqs. 20-22, 28, 29, 35).
///
/// The drag on a sphere is K (u − v) with K = V β/(1 − α), linearised at the old slip and implicit in both velocities:
/// with v advanced by Eq. 35, F = K' (u − v'), K' = K / (1 + K Δt/m) and v' the velocity that all other forces alone
/// would give. The liquid is solved with K' and v' on its momentum nodes, and the spheres then receive exactly the
/// same F as a constant force over their steps. The spheres' shares φ that make the void fraction also gather the
/// liquid's velocity, pressure gradient and viscous force, so that every impulse on one phase is taken from the other.
///
/// Local voidage and slip are those of the shares, Σ φ α and Σ φ u.
class PhaseCoupling {
 public:
  /// `liquid` may be null: quiescent liquid, single-sphere drag (voidage 1), nothing given back.
  PhaseCoupling(const Scene& scene, fluid::LiquidSolver* liquid);

  /// Solves the liquid over `time_step` from the present spheres and sets their external_force.
  void advance(dem::Engine& engine, double time_step);

  /// Tells that a sphere has been put in or taken out: the next step sees no liquid displaced by it.
  void forget_void_fraction() { liquid_before_.clear(); }

  /// Values at the spheres after the last advance.
  [[nodiscard]] double voidage(std::size_t i) const { return voidage_[i]; }
  [[nodiscard]] double reynolds(std::size_t i) const { return reynolds_[i]; }
  [[nodiscard]] double liquid_velocity(std::size_t i, std::size_t a) const { return liquid_velocity_[a][i]; }
  [[nodiscard]] double drag_force(std::size_t i, std::size_t a) const { return drag_[a][i]; }
  /// −V ∇p with the static pressure [N].
  [[nodiscard]] double pressure_force(std::size_t i, std::size_t a) const { return pressure_force_[a][i]; }

  /// Drag that left the liquid over the last step, from its own momentum nodes [N].
  [[nodiscard]] double drag_taken_from_liquid(std::size_t a) const;

  /// Void fraction per cell after the last advance [-]; empty without a liquid.
  [[nodiscard]] std::vector<double> void_fraction() const;
  [[nodiscard]] std::array<std::vector<double>, 3> cell_velocity() const;

  /// Wall time spent so far on void fractions [s].
  [[nodiscard]] double void_fraction_seconds() const { return void_fraction_seconds_; }

  /// Liquid volume per cell at the last step, for checkpoints [m³].
  [[nodiscard]] const std::vector<double>& liquid_volume() const { return liquid_before_; }
  void restore(std::vector<double> liquid_volume) { liquid_before_ = std::move(liquid_volume); }

 private:
  using LawKernel = std::function<void(std::span<const double> voidage, std::span<const double> reynolds,
                                       std::span<double> dimensionless_drag)>;

  void resize(std::size_t n);
  void measure_slip(const dem::Particles& particles);
  void predict_velocity(const dem::Engine& engine, double time_step);

  const Scene& scene_;
  fluid::LiquidSolver* liquid_;
  std::optional<VolumeShares> shares_;  ///< none without a liquid
  LawKernel law_;
  std::vector<double> liquid_before_, liquid_now_, solid_, cell_voidage_, cell_values_;
  fluid::Exchange exchange_;
  std::vector<double> volume_, voidage_, reynolds_, dimensionless_drag_, coefficient_, momentum_;
  std::array<std::vector<double>, 3> liquid_velocity_, drag_, pressure_force_, other_force_, predicted_velocity_,
      stress_, cell_velocity_, cell_stress_;
  double void_fraction_seconds_ = 0.0;
};

}  // namespace slfb::coupling
