#pragma once

#include <array>
#include <optional>
#include <vector>

#include "correlations/materials.hpp"
#include "solver/coupling/forces/basset_history.hpp"
#include "solver/coupling/forces/disturbance_correction.hpp"
#include "solver/dem/particles.hpp"
#include "solver/scene/scene.hpp"
#include "solver/support/named_fields.hpp"
#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// The forces beyond drag, pressure gradient and buoyancy that a scene switches on, and what they remember of each
/// sphere: added mass, Saffman's and Magnus's lift, Basset's history force, and the correction of the slip by the
/// sphere's own disturbance.
///
/// All but the history's newest part, which is linear in the slip, are taken from the start of the liquid step as
/// constant forces over it, and leave the liquid as the same impulse. The part of the added mass that resists the
/// sphere's own acceleration is an inertia (dem::Particles::added_mass); the liquid receives it one step late, and
/// until then it is on its way (momentum_on_its_way()).
class ForcesBeyondDrag {
 public:
  /// Inactive unless a force is on in `scene`: see any(). \param time_step of the liquid [s]
  ForcesBeyondDrag(const Scene& scene, double time_step);

  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] bool corrects_disturbance() const { return coupling_.disturbance_correction; }
  /// Whether gradients of the liquid's velocity are needed.
  [[nodiscard]] bool need_gradients() const {
    return coupling_.saffman_lift || coupling_.magnus_lift || coupling_.added_mass > 0.0;
  }

  /// Takes in the velocity of the liquid at each sphere [m/s] before the step, sets the spheres' added mass [kg] and
  /// makes room for new spheres, which start from their present slip.
  void start_step(dem::Particles& particles, const std::array<std::vector<double>, 3>& liquid_velocity);
  /// Sphere i has been taken out; those after it move up by one.
  void remove(std::size_t i);

  /// The undisturbed liquid around one sphere.
  struct Surroundings {
    Vec3 velocity;                   ///< [m/s]
    std::array<Vec3, 3> gradient{};  ///< ∇u_a per component [1/s]
    /// ∇ × u [1/s].
    [[nodiscard]] Vec3 vorticity() const {
      return {gradient[2].y - gradient[1].z, gradient[0].z - gradient[2].x, gradient[1].x - gradient[0].y};
    }
  };
  struct Effect {
    Vec3 force;                ///< on the sphere over the coming step [N]
    Vec3 reaction;             ///< on the liquid over the coming step [N]
    double coefficient = 0.0;  ///< of the part that is linear in the slip, beside the drag's K [kg/s]
  };
  /// On sphere i over the coming step, by the laws in forces/.
  [[nodiscard]] Effect effect(const dem::Particles& particles, std::size_t i, const Surroundings& liquid) const;
  /// Change of the angular velocity over the coming step by the liquid's torque, implicit in it [rad/s].
  [[nodiscard]] Vec3 change_of_angular_velocity(const dem::Particles& particles, std::size_t i,
                                                const Surroundings& liquid) const;

  /// Momentum that the spheres' added mass has taken since the start of the last step, which the liquid loses in the
  /// next, along axis a (x, y, z) [kg m/s].
  [[nodiscard]] double momentum_on_its_way(const dem::Particles& particles, std::size_t a) const;

  /// Velocity that the sphere's own force has given to the liquid it reads [m/s].
  [[nodiscard]] Vec3 self_induced(std::size_t i) const { return self_induced_[i]; }
  /// After the step: the force of sphere i on the liquid [N] acts on the velocity that it will read.
  /// \param concentration Σ φ²/V_c of its shares [1/m³]; \param voidage [-] and \param slip [m/s] at the sphere
  void disturb(std::size_t i, Vec3 force_on_liquid, double concentration, double voidage, double slip);

  /// All that the next step depends on, for checkpoints: self_induced_x and so on, liquid_velocity_x, sphere_velocity_x
  /// per sphere [m/s]; basset_history and basset_newest where that force is on.
  [[nodiscard]] NamedFields state() const;
  /// \throws std::runtime_error if a field is missing or of another length, std::invalid_argument if the history has
  /// another window
  void restore(const NamedFields& state, std::size_t spheres);

 private:
  Coupling coupling_;
  LiquidProperties liquid_;
  double time_step_;
  bool any_;
  SelfInducedVelocity disturbance_;
  std::optional<BassetHistory> history_;
  std::vector<Vec3> self_induced_;
  std::vector<Vec3> liquid_before_, sphere_before_;  ///< velocities at the start of the last step [m/s]
  std::vector<Vec3> liquid_now_, sphere_now_;        ///< and at its end
};

}  // namespace slfb::coupling
