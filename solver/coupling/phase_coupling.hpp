#pragma once

#include <array>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "correlations/drag/drag_law_kernels.hpp"
#include "solver/coupling/forces_beyond_drag.hpp"
#include "solver/coupling/liquid_volumes.hpp"
#include "solver/coupling/point_values.hpp"
#include "solver/dem/engine.hpp"
#include "solver/fluid/liquid.hpp"

namespace slfb::coupling {

/// A drag law threw, or gave a drag that is negative or not finite. what() names the law, its file and the flow.
struct LawError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Momentum exchange between spheres and liquid over one liquid step (Peng 2014, Eqs. 20-22, 28, 29, 35).
///
/// The drag on a sphere is K (u − v) with K = V β/(1 − α), linearised at the old slip. In the semi-implicit scheme it
/// is implicit in both velocities: with v advanced by Eq. 35, F = K' (u − v'), K' = K/(1 + K Δt/m) and v' the velocity
/// that all other forces alone would give. The liquid is solved with K' and v' on its momentum nodes, the stress in v'
/// being that of the same moment, and the spheres then receive exactly the same F as a constant force over their steps.
/// The implicit scheme repeats this with β at the new slip until it no longer changes; the explicit one takes F = K (u
/// − v) from before the step.
///
/// The spheres' shares φ that make the void fraction also gather the liquid's velocity, pressure gradient and viscous
/// force, so that every impulse on one phase is taken from the other. Where voidage and velocity are asked for at the
/// sphere's centre instead, the difference enters as a correction of the slip and leaves that pairing as it is.
///
/// With a liquid of given velocity (one-way coupling, fluid::Liquid::two_way()) nothing is given back: the spheres feel
/// the drag of single spheres in it, in a single pass, and no disturbance of their own.
class PhaseCoupling {
 public:
  /// Scene and liquid must outlive the coupling. \param drag_law called once per block of spheres
  PhaseCoupling(const Scene& scene, fluid::Liquid& liquid, const drag::DragLawKernels& drag_law);

  /// Solves the liquid over `time_step` [s] from the present spheres, sets their external_force and, with Magnus's
  /// lift, turns them. \throws fluid::FluidError as Liquid::advance() does (a cell without liquid, an equation that
  /// does not converge, a value that is not finite), if the drag law throws or gives a drag that is negative or not
  /// finite (it is named), and if the implicit exchange does not converge within 50 passes; std::invalid_argument if a
  /// sphere is larger than the largest of the scene's species
  void advance(dem::Engine& engine, double time_step);

  /// Tells that a sphere has been put in, or that sphere i has been taken out: the next step sees no liquid displaced
  /// by that.
  void sphere_added() { volumes_.start_anew(); }
  void sphere_removed(std::size_t i);

  /// At sphere i after the last advance: voidage α [-], Re = ρ d α |u − v|/μ [-], liquid velocity [m/s] and drag [N]
  /// along axis a. With forces beyond drag the latter holds what is linear in the slip of the history force too.
  /// `knows`: sphere i took part in that advance.
  [[nodiscard]] bool knows(std::size_t i) const { return i < voidage_.size(); }
  [[nodiscard]] double voidage(std::size_t i) const { return voidage_[i]; }
  [[nodiscard]] double reynolds(std::size_t i) const { return reynolds_[i]; }
  [[nodiscard]] double liquid_velocity(std::size_t i, std::size_t a) const { return liquid_velocity_[a][i]; }
  [[nodiscard]] double drag_force(std::size_t i, std::size_t a) const { return drag_[a][i]; }
  /// −V ∇p with the static pressure [N]; reads the whole field for one sphere.
  [[nodiscard]] double pressure_force(std::size_t i, std::size_t a);

  /// Drag that left the liquid over the last step, from its own momentum nodes [N]; 0 in one-way coupling.
  [[nodiscard]] double drag_taken_from_liquid(std::size_t a) const { return liquid_.taken_by(exchange_, a); }

  /// Momentum of the spheres' added mass that the liquid gets in the next step, along axis a [kg m/s].
  [[nodiscard]] double momentum_on_its_way(const dem::Particles& particles, std::size_t a) const {
    return beyond_drag_.any() ? beyond_drag_.momentum_on_its_way(particles, a) : 0.0;
  }

  /// Void fraction per cell after the last advance [-]; empty in one-way coupling.
  [[nodiscard]] std::vector<double> void_fraction() const;
  /// Liquid velocity per cell after the last advance [m/s].
  [[nodiscard]] const std::array<std::vector<double>, 3>& cell_velocity() const { return cell_velocity_; }
  /// Liquid volume per cell at the last step [m³]; empty in one-way coupling.
  [[nodiscard]] const std::vector<double>& liquid_volume() const { return volumes_.before(); }

  /// Wall time spent so far on void fractions [s].
  [[nodiscard]] double void_fraction_seconds() const { return void_fraction_seconds_; }
  /// Passes over the liquid of the last step: 1 but for the implicit scheme.
  [[nodiscard]] int passes() const { return passes_; }

  /// All that the next step depends on beside the spheres and the liquid, for checkpoints: that of LiquidVolumes, and
  /// forces_beyond_drag/... of ForcesBeyondDrag.
  [[nodiscard]] NamedFields state() const;
  /// Continues from a state() with the spheres of the same moment. \throws std::runtime_error if a field is missing
  /// or has another length
  void restore(const NamedFields& state, const dem::Particles& particles);

 private:
  void resize(std::size_t n);
  /// The slip of some sphere is not that of the mean by which it gives and takes.
  [[nodiscard]] bool slip_is_corrected() const { return at_centres_ || corrects_disturbance_ || volumes_.lone().any(); }
  [[nodiscard]] bool drag_is_explicit() const { return scene_.coupling.exchange == MomentumExchange::explicit_in_time; }
  void update_void_fraction(const dem::Engine& engine, double time_step);
  void read_liquid(int threads);
  [[nodiscard]] std::array<double, 8> mean_by_shares(std::size_t i) const;
  void update_section_means();
  void read_at_spheres(const dem::Engine& engine, double time_step);
  void apply_forces_beyond_drag(dem::Engine& engine);
  [[nodiscard]] double own_concentration(std::size_t i) const;
  void give_to_liquid(const dem::Engine& engine, double time_step);
  void give_to_spheres(dem::Engine& engine, double time_step);
  [[nodiscard]] double update_coefficient(const dem::Engine& engine, double time_step);
  void evaluate_law(const dem::Particles& particles, std::size_t begin, std::size_t end, std::vector<double>& result);
  void keep_law_error(std::exception_ptr error);
  void raise_law_error();
  void disturb_liquid(const dem::Particles& particles);

  const Scene& scene_;
  fluid::Liquid& liquid_;
  std::array<double, 3> gravity_;  ///< [m/s²]
  drag::DragKernel law_;
  std::string law_name_;                       ///< as errors call it
  double (*wall_law_)(double diameter_ratio);  ///< terminal velocity in a tube over that without walls; may be null
  std::exception_ptr law_error_;               ///< the first of this step
  LiquidVolumes volumes_;
  PointValues point_values_;
  ForcesBeyondDrag beyond_drag_;
  // What only a liquid that the spheres act on has: voidage and velocity read at the spheres' centres, the slip
  // corrected by their own disturbance, drag that is iterated.
  bool at_centres_, corrects_disturbance_, implicit_;
  std::vector<CellValues> cells_;                     ///< what the spheres read
  std::vector<std::array<double, 8>> section_means_;  ///< of that, per layer; only where spheres are alone
  bool cells_valid_ = false;
  bool velocity_is_gathered_ = false;  ///< liquid_velocity_ is that of cells_ by the present shares
  /// Per cell: u [m/s], −∇p + ∇·τ with the dynamic pressure [N/m³].
  std::array<std::vector<double>, 3> cell_velocity_, cell_stress_;
  std::array<std::vector<double>, 5> scattered_;  ///< per cell: K', K' v' without stress, its volume
  fluid::Exchange exchange_;
  // Per sphere: volume [m³], voidage and Re [-], K, K' and the next K of the implicit scheme [kg/s].
  std::vector<double> volume_, voidage_, reynolds_, coefficient_, damped_coefficient_, next_coefficient_;
  /// Of the sphere's centre over the mean by shares, of the liquid's velocity [m/s].
  std::array<std::vector<double>, 3> velocity_correction_;
  std::array<std::vector<double>, 3> liquid_velocity_;  ///< [m/s]
  std::array<std::vector<double>, 3> drag_;             ///< [N]
  std::array<std::vector<double>, 3> momentum_;         ///< K' v' without stress [N]
  std::array<std::vector<double>, 3> free_velocity_;    ///< v advanced without the liquid's stress and drag [m/s]
  std::vector<double> stressed_volume_;  ///< V K' Δt/m: through it the stress in v' acts on the liquid [m³]
  /// Of the forces beyond drag: on the spheres and on the liquid [N], and beside K [kg/s].
  std::array<std::vector<double>, 3> beyond_force_, beyond_reaction_;
  std::vector<double> beyond_coefficient_;
  double void_fraction_seconds_ = 0.0;
  int passes_ = 1;
};

}  // namespace slfb::coupling
