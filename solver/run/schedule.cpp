#include "solver/run/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slfb::simulation {

bool Schedule::in_last_fluidisation() const {
  if (stage().kind != StageKind::fluidise) return false;
  const auto next = static_cast<std::size_t>(stage_) + 1;
  return next >= stages_.size() || stages_[next].kind != StageKind::fluidise;
}

void Schedule::count_step() {
  ++steps_;
  if (stage().kind != StageKind::settle) ++fluidised_steps_;
}

void Schedule::next_stage() {
  ++stage_;
  steps_ = 0;
}

std::int64_t Schedule::steps_in(double duration) const { return std::llround(duration / time_step_); }

std::int64_t Schedule::interval_steps(double interval) const { return std::max<std::int64_t>(1, steps_in(interval)); }

double Schedule::planned_seconds(std::optional<double> fall) const {
  constexpr double usual_fall = 3.0;  // [s]
  double sum = 0.0;
  for (const Stage& stage : stages_)
    sum += stage.kind == StageKind::drop
               ? stage.repetitions * (fall.value_or(std::min(stage.duration, usual_fall)) + stage.relaxation)
               : stage.duration;
  return sum;
}

void Schedule::exchange(io::StateGroup& group) {
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  group.value("stage", stage_, 0, static_cast<std::int64_t>(stages_.size()));
  group.value("steps", steps_, 0, any);
  group.value("fluidised_steps", fluidised_steps_, 0, any);
}

}  // namespace slfb::simulation
