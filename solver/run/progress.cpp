#include "solver/run/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "solver/run/drop_protocol.hpp"
#include "solver/run/schedule.hpp"

namespace slfb::simulation {
namespace {

std::string stage_name(const Schedule& schedule, const DropProtocol& drops) {
  static constexpr std::array names{"settle", "fluidise", "drop"};
  const Stage& stage = schedule.stage();
  const char* name = names[static_cast<std::size_t>(stage.kind)];
  if (stage.kind != StageKind::drop) return name;
  return fmt::format("{} {}/{}", name, drops.repetition() + 1, stage.repetitions);
}

}  // namespace

void ProgressReporter::step_done(const Schedule& schedule, const DropProtocol& drops, const RunResult& result,
                                 double wall_seconds) {
  if (!report_) return;
  const auto now = Clock::now();
  if (std::chrono::duration<double>(now - last_report_).count() < interval_) return;
  last_report_ = now;
  std::optional<double> fall;
  if (!result.drops.empty() && result.drops.front().bottom_time > 0.0) fall = result.drops.front().bottom_time;
  const double since_start = std::chrono::duration<double>(now - started_).count();
  Progress progress;
  progress.stage = stage_name(schedule, drops);
  progress.simulated_seconds = result.simulated_seconds;
  progress.planned_seconds = std::max(schedule.planned_seconds(fall), result.simulated_seconds);
  progress.wall_seconds = wall_seconds;
  progress.particle_steps_per_second =
      static_cast<double>(result.particle_steps - steps_at_start_) / std::max(1e-9, since_start);
  report_(progress);
}

}  // namespace slfb::simulation
