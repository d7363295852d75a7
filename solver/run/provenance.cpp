#include "solver/run/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <ctime>
#include <numbers>
#include <thread>

#include "solver/laws/scene_file.hpp"
#include "solver/support/commit.hpp"
#include "solver/support/processor.hpp"

namespace slfb::simulation {

RunResult new_result(const Scene& scene, int threads) {
  RunResult result;
  result.name = scene_hash(scene);
  result.scene_text = canonical_toml(scene);
  result.suite_version = SLFB_VERSION;
  result.commit = suite_commit();
  result.threads = threads;
  result.steps_per_contact = std::numbers::pi * contact_time_step_bound(scene) / scene.contact.time_step;
  result.machine = fmt::format("{}, {} cores", processor_name(), std::thread::hardware_concurrency());
  return result;
}

void RunCost::resume(const RunResult& result) {
  wall_before_ = result.wall_seconds;
  cpu_before_ = result.cpu_seconds;
}

double RunCost::wall_seconds() const {
  return wall_before_ + std::chrono::duration<double>(Clock::now() - started_).count();
}

void RunCost::write_to(RunResult& result) const {
  result.wall_seconds = wall_seconds();
  result.cpu_seconds = cpu_before_ + (thread_cpu_seconds() - cpu_at_start_) * threads_;
  result.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace slfb::simulation
