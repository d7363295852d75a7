#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/io/state_group.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::simulation {

/// Where a run stands in the stages of its scene, counted in liquid steps.
///
/// The clock of the records starts with the first stage after settling.
class Schedule {
 public:
  /// \param stages of the scene, which must outlive the schedule
  /// \param time_step of the liquid [s]
  Schedule(const std::vector<Stage>& stages, double time_step) : stages_(stages), time_step_(time_step) {}

  /// True after the last stage.
  [[nodiscard]] bool finished() const { return stage_ >= static_cast<std::int64_t>(stages_.size()); }
  /// The present stage; only before finished().
  [[nodiscard]] const Stage& stage() const { return stages_[static_cast<std::size_t>(stage_)]; }
  /// Whether the present stage is the last one that fluidises the bed.
  [[nodiscard]] bool in_last_fluidisation() const;
  void count_step();
  void next_stage();

  /// Liquid steps in the present stage.
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  /// Whether the present stage has lasted for its duration; a drop stage ends in another way (DropProtocol).
  [[nodiscard]] bool duration_is_over() const { return steps_ >= steps_in(stage().duration); }
  [[nodiscard]] bool in_second_half() const { return 2 * steps_ > steps_in(stage().duration); }

  /// Time since the end of settling [s].
  [[nodiscard]] double fluidised_seconds() const { return static_cast<double>(fluidised_steps_) * time_step_; }
  /// Whether something that is done every `interval` [s] on that clock is due in this step, at most once a step.
  [[nodiscard]] bool due(double interval) const { return fluidised_steps_ % interval_steps(interval) == 0; }

  /// Liquid steps in a time [s], rounded.
  [[nodiscard]] std::int64_t steps_in(double duration) const;
  /// The same, but at least one.
  [[nodiscard]] std::int64_t interval_steps(double interval) const;
  [[nodiscard]] double time_step() const { return time_step_; }

  /// Simulated time of all stages [s]. A drop ends when its sphere arrives: `fall` is the time that one takes, as far
  /// as it is known [s].
  [[nodiscard]] double planned_seconds(std::optional<double> fall) const;

  void exchange(io::StateGroup& group);

 private:
  const std::vector<Stage>& stages_;
  double time_step_;
  std::int64_t stage_ = 0, steps_ = 0, fluidised_steps_ = 0;
};

}  // namespace slfb::simulation
