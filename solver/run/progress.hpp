#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "solver/io/run_result.hpp"

namespace slfb {

/// How far a run has come.
struct Progress {
  std::string stage;               ///< "settle", "fluidise", "drop 2/10"
  double simulated_seconds = 0.0;  ///< [s]
  double planned_seconds = 0.0;    ///< of all stages; for drops an estimate from the spheres that have arrived [s]
  double wall_seconds = 0.0;       ///< with those before an interruption [s]
  double particle_steps_per_second = 0.0;  ///< since the last start [1/s]
};

namespace simulation {

class DropProtocol;
class Schedule;

/// Reports to the caller of run_scene how far the run has come, at intervals of wall-clock time.
class ProgressReporter {
 public:
  /// \param report called with the progress; may be empty
  /// \param interval between calls, wall-clock time [s]
  ProgressReporter(std::function<void(const Progress&)> report, double interval)
      : report_(std::move(report)), interval_(interval) {}

  /// The run goes on from this result: what follows counts as the work of this start.
  void start(const RunResult& result) { steps_at_start_ = result.particle_steps; }
  /// Reports if that is due. `wall_seconds`: of the run so far [s].
  void step_done(const Schedule& schedule, const DropProtocol& drops, const RunResult& result, double wall_seconds);

 private:
  using Clock = std::chrono::steady_clock;

  std::function<void(const Progress&)> report_;
  double interval_;
  Clock::time_point started_ = Clock::now(), last_report_ = started_;
  std::int64_t steps_at_start_ = 0;
};

}  // namespace simulation
}  // namespace slfb
