#pragma once

#include <cstdint>

#include "solver/io/state_group.hpp"
#include "solver/run/schedule.hpp"

namespace slfb::simulation {

/// The order of events of a drop stage, counted in liquid steps: release, fall, taking out, relaxation, next release.
///
/// A sphere is released only where no sphere of the bed lies. In a bed that reaches up to there spheres come and go, so
/// the release waits, as long as a drop may take. After that the bed counts as one that fills its column, and the
/// stage ends without further drops.
class DropProtocol {
 public:
  /// \param schedule whose present stage is the drop stage when a function is called; must outlive the protocol
  explicit DropProtocol(const Schedule& schedule) : schedule_(schedule) {}

  /// Starts a drop stage: a release is due at once.
  void begin();
  /// Counts one liquid step of a drop stage.
  void count_step();
  /// Whether the stage is over: its last sphere has been taken out and the bed has relaxed, or there was no room.
  [[nodiscard]] bool finished() const { return repetition_ >= schedule_.stage().repetitions; }

  /// Number of the present drop in its stage, from 0.
  [[nodiscard]] std::int64_t repetition() const { return repetition_; }
  [[nodiscard]] bool falling() const { return falling_; }
  /// Liquid steps, and time [s], since the present sphere was released.
  [[nodiscard]] std::int64_t fall_steps() const { return phase_steps_; }
  [[nodiscard]] double fall_seconds() const { return static_cast<double>(phase_steps_) * schedule_.time_step(); }
  /// Whether the sphere that falls has done so for the stage's duration.
  [[nodiscard]] bool fall_is_over() const { return phase_steps_ >= schedule_.steps_in(schedule_.stage().duration); }

  /// Whether a sphere is to be released, if there is room.
  [[nodiscard]] bool release_is_due() const;
  /// Whether a release has been due for the stage's duration.
  [[nodiscard]] bool waited_too_long() const;

  void released();
  void taken_out();
  /// Ends the stage without further drops.
  void give_up() { repetition_ = schedule_.stage().repetitions; }

  void exchange(io::StateGroup& group);

 private:
  [[nodiscard]] std::int64_t relaxation_steps() const { return schedule_.interval_steps(schedule_.stage().relaxation); }

  const Schedule& schedule_;
  std::int64_t repetition_ = 0;
  bool falling_ = false;
  std::int64_t phase_steps_ = 0;  ///< since the present sphere was released, or the last one taken out
};

}  // namespace slfb::simulation
