#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/fluid/prescribed_liquid.hpp"
#include "solver/io/state_group.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::simulation {

/// What is around the spheres over a step.
enum class Surroundings {
  nothing,  ///< weight and contacts alone act on the spheres
  resting_liquid,
  liquid
};

/// Spheres and liquid of a scene and how they advance together; knows no stages and records nothing.
///
/// Spheres are put in and taken out here, so that engine and coupling always agree on them.
class Model {
 public:
  /// A column without spheres. `scene` must outlive the model.
  Model(const Scene& scene, int threads);

  /// Puts the spheres of the bed in, where the scene starts them. Throws SceneError if they do not fit.
  void fill();

  /// One liquid step: exchange, liquid, then the spheres in their own steps. With `resting_liquid` and with `nothing`
  /// the liquid of the scene waits. Returns the sphere steps that were done. Throws dem::EngineError or
  /// fluid::FluidError if the motion or the liquid breaks down.
  std::int64_t advance(Surroundings surroundings);

  /// Superficial velocity of the liquid from the next step on [m/s].
  void set_superficial_velocity(double velocity) { liquid_->set_superficial_velocity(velocity); }

  /// Whether a sphere of `species` has room with its centre on the axis at `height` [m].
  [[nodiscard]] bool has_room(const Species& species, double height) const;
  /// Puts the dropped sphere in, at rest, there.
  void release(const Species& species, double height);
  /// Index of the dropped sphere, if it is in the column.
  [[nodiscard]] std::optional<std::size_t> dropped() const { return dropped_; }
  [[nodiscard]] bool dropped_sphere_at_bottom() const;
  /// Whether its centre is above the column's height.
  [[nodiscard]] bool dropped_sphere_above_top() const;
  void take_out_dropped();
  /// Takes out all spheres of the bed above the column's height; returns how many.
  std::int64_t remove_above_top();

  [[nodiscard]] const dem::Engine& engine() const { return engine_; }
  [[nodiscard]] const dem::Particles& particles() const { return engine_.particles; }
  /// The liquid of the scene; while the bed settles it waits.
  [[nodiscard]] const fluid::Liquid& liquid() const { return *liquid_; }
  /// Between the spheres and that liquid.
  [[nodiscard]] coupling::PhaseCoupling& coupling() { return *flowing_; }
  [[nodiscard]] const coupling::PhaseCoupling& coupling() const { return *flowing_; }

  /// The deepest contact since the last call, see dem::Engine.
  [[nodiscard]] std::optional<dem::Engine::DeepContact> take_deepest_contact() {
    return engine_.take_deepest_contact();
  }

  /// Σ m v_z of the spheres, with what their added mass has on its way to the liquid [kg m/s].
  [[nodiscard]] double sphere_momentum() const;

  /// Everything that the next step depends on.
  void exchange(io::StateGroup& state);

 private:
  void exchange_engine(io::StateGroup& group);

  const Scene& scene_;
  dem::Engine engine_;
  fluid::PrescribedLiquid liquid_at_rest_;  ///< while the bed settles
  std::unique_ptr<fluid::Liquid> liquid_;
  std::unique_ptr<coupling::PhaseCoupling> resting_, flowing_;  ///< with the one and the other liquid
  std::int64_t sphere_steps_;                                   ///< per liquid step
  std::optional<std::size_t> dropped_;
};

}  // namespace slfb::simulation
