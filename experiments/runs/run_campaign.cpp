#include "experiments/runs/run_campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>

#include "experiments/runs/measure.hpp"
#include "experiments/runs/progress_display.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/runs/run_lock.hpp"
#include "experiments/runs/stop_signals.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/simulation.hpp"
#include "solver/support/files.hpp"

namespace slfb {
namespace {

struct Task {
  std::string label, hash;
  const Scene* scene;
  std::size_t place;  ///< among the scenes asked for
  double cost;
};

enum class Ending { finished, failed, interrupted };

/// Writes a scene with its laws from files beside it, so that the folder alone can be run again.
void archive_scene(const Scene& scene, const std::filesystem::path& directory) {
  Scene archived = scene;
  for (auto& [law, name] : {std::pair<std::string&, std::string>{archived.coupling.drag_law, "drag_law.cpp"},
                            std::pair<std::string&, std::string>{archived.contact.law, "contact_law.cpp"}}) {
    if (!is_user_law(law)) continue;
    const std::string file = user_law_file(law);
    write_file(directory / name, user_law_text(file));
    law = name + law.substr(file.size());
  }
  write_file(directory / "scene.toml", canonical_toml(archived));
}

/// Runs one task and reports how it ended; `failure` is why where it failed.
Ending run_task(const Task& task, std::size_t number, const CampaignOptions& options, const std::atomic<bool>& stop,
                ProgressDisplay& display, std::string& failure) {
  const auto directory = run_directory(options.out, task.hash);
  std::optional<WorkToSave> state;
  const auto failed = [&](const std::string& why) {
    display.end(number, fmt::format("{}: FAILED: {}", task.label, why));
    failure = fmt::format("{}: {}", task.label, why);
    return Ending::failed;
  };
  try {
    make_output_folder(directory.parent_path());
    make_output_folder(directory);
    const RunLock lock(directory);
    if (std::filesystem::exists(result_file(options.out, task.hash))) {  // another process was faster
      display.end(number, fmt::format("{}: finished by another slfb", task.label));
      return Ending::finished;
    }
    for (const auto& folder : {directory, directory / "snapshots"}) remove_unfinished(folder);
    archive_scene(*task.scene, directory);
    if (std::filesystem::exists(directory / "checkpoint.h5")) {
      display.message(fmt::format("{}: goes on from its last checkpoint", task.label));
    }
    display.start(number);
    const RunOutcome outcome =
        run_scene(*task.scene, {.threads = options.threads_per_run,
                                .directory = directory,
                                .progress = [&](const Progress& progress) { display.update(number, progress); },
                                .started = [&] { state.emplace(); },
                                .stop = &stop});
    if (outcome.status == RunStatus::interrupted) {
      display.end(number,
                  fmt::format("{}: stopped at {:.2f} s, state saved", task.label, outcome.result.simulated_seconds));
      return Ending::interrupted;
    }
    if (!std::filesystem::is_directory(directory))
      display.message(fmt::format("{}: its folder {} had vanished and is made anew", task.label, directory.string()));
    save_result(outcome.result, result_file(options.out, task.hash));
    remove_checkpoints(directory);
    display.end(number, fmt::format("{}: finished, {:.2f} s simulated in {}", task.label,
                                    outcome.result.simulated_seconds, format_duration(outcome.result.wall_seconds)));
    return Ending::finished;
  } catch (const std::bad_alloc&) {
    return failed("the memory of this machine is used up; fewer spheres, fewer cells or fewer runs side by side");
  } catch (const std::exception& error) {
    return failed(error.what());
  }
}

}  // namespace

CampaignOutcome run_scenes(const std::vector<NamedScene>& scenes, const CampaignOptions& requested) {
  CampaignOutcome outcome;
  std::vector<Task> tasks;
  std::set<std::string> hashes;
  for (std::size_t place = 0; place < scenes.size(); ++place) {
    const auto& [label, scene] = scenes[place];
    std::string hash = scene_hash(scene);
    if (!hashes.insert(hash).second) continue;
    if (std::filesystem::exists(result_file(requested.out, hash))) {
      ++outcome.skipped;
    } else {
      tasks.push_back({label, std::move(hash), &scene, place, estimate_run(scene).core_seconds});
    }
  }
  if (tasks.empty()) return outcome;
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.cost > b.cost; });

  CampaignOptions options = requested;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.threads_per_run = std::clamp(options.threads_per_run, 1, cores);
  options.jobs = std::clamp(options.jobs, 1, std::min(cores / options.threads_per_run, static_cast<int>(tasks.size())));

  std::vector<ProgressDisplay::Job> shown;
  for (const Task& task : tasks) shown.push_back({task.label, task.cost});
  ProgressDisplay display(std::move(shown), options.jobs, options.progress, options.heading);
  const StopSignals signals;

  std::mutex mutex;
  std::condition_variable changed;
  std::size_t next = 0;
  int working = options.jobs;
  std::vector<Ending> endings(tasks.size(), Ending::interrupted);
  const auto work = [&] {
    for (;;) {
      std::size_t number = 0;
      {
        const std::lock_guard lock(mutex);
        if (next == tasks.size() || signals.requested()) {
          --working;
          changed.notify_one();
          return;
        }
        number = next++;
      }
      std::string failure;
      Ending ending = run_task(tasks[number], number, options, signals.requested(), display, failure);
      const std::lock_guard lock(mutex);
      if (ending == Ending::finished && options.finished) try {
          options.finished(tasks[number].place);
        } catch (const std::exception& error) {
          ending = Ending::failed;
          failure = fmt::format("{}: {}", tasks[number].label, error.what());
          display.message(failure);
        }
      endings[number] = ending;
      if (ending == Ending::failed) outcome.failures.push_back(std::move(failure));
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int job = 0; job < options.jobs; ++job) threads.emplace_back(work);
    bool announced = false;
    for (std::unique_lock lock(mutex); working > 0;) {
      // Wakes up between notices to draw and to see a signal.
      changed.wait_for(lock, std::chrono::milliseconds(100), [&] { return working == 0; });
      if (signals.requested() && !announced && working > 0) {
        display.message(
            "Stopping: the state of each run is being saved. Ctrl-C once more ends at once, without saving.");
        announced = true;
      }
      display.refresh();
    }
  }
  for (const Ending ending : endings) {
    ++(ending == Ending::finished ? outcome.finished : ending == Ending::failed ? outcome.failed : outcome.interrupted);
  }
  if (outcome.interrupted > 0) {
    display.message(fmt::format("Interrupted: {} finished, {} to go. The same command goes on where this one stopped.",
                                outcome.finished + outcome.skipped, outcome.unfinished()));
  }
  return outcome;
}

CampaignOutcome run_campaign(const std::vector<RunSpec>& specs, const CampaignOptions& options) {
  std::vector<NamedScene> scenes;
  for (const RunSpec& spec : specs) scenes.push_back({run_key(spec), load_run_scene(spec)});
  return run_scenes(scenes, options);
}

}  // namespace slfb
