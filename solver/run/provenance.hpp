#pragma once

#include <chrono>

#include "solver/io/run_result.hpp"
#include "solver/support/processor.hpp"

namespace slfb::simulation {

/// What says where a result comes from: scene, versions, machine and threads. Everything else of it is empty.
RunResult new_result(const Scene& scene, int threads);

/// Wall and CPU time of a run, over all of its starts. The CPU time is that of the calling thread, which leads the run,
/// times the threads, which keep in step with it: other runs of the process do not count.
class RunCost {
 public:
  explicit RunCost(int threads) : threads_(threads) {}

  /// The run goes on from this result: its times are added to those of this start.
  void resume(const RunResult& result);
  [[nodiscard]] double wall_seconds() const;
  /// Puts the times [s] and today's date into the result.
  void write_to(RunResult& result) const;

 private:
  using Clock = std::chrono::steady_clock;

  int threads_;
  Clock::time_point started_ = Clock::now();
  double cpu_at_start_ = thread_cpu_seconds();
  double wall_before_ = 0.0, cpu_before_ = 0.0;  ///< by earlier starts [s]
};

}  // namespace slfb::simulation
