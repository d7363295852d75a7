#include "experiments/numerics/studies/trial_store.hpp"

#include <spdlog/spdlog.h>

#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "experiments/quantities/json_file.hpp"
#include "experiments/runs/stop_signals.hpp"
#include "solver/support/files.hpp"

namespace slfb::studies {
namespace {

using nlohmann::ordered_json;

}  // namespace

std::filesystem::path TrialStore::file_of(const Trial& trial) const {
  return folder_ / trial.problem / (trial.hash() + ".json");
}

std::optional<TrialResult> TrialStore::find(const Trial& trial) const {
  const auto file = file_of(trial);
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    return read_json(file, "a solved trial", [](const ordered_json& kept) {
      TrialResult result;
      for (const auto& [name, value] : kept.at("values").items())
        result.values[name] = {number_or_nan(value.at("value")), number_or_nan(value.at("error")),
                               number_or_nan(value.at("exact"))};
      result.counts = kept.at("counts").get<std::map<std::string, double>>();
      result.cpu_seconds = kept.at("cpu_seconds");
      result.failure = kept.at("failure");
      result.machine = kept.at("machine");
      return result;
    });
  } catch (const std::runtime_error& error) {
    spdlog::warn("solved again: {}", error.what());
    return std::nullopt;
  }
}

void TrialStore::keep(const Trial& trial, const TrialResult& result) const {
  const auto file = file_of(trial);
  std::filesystem::create_directories(file.parent_path());
  ordered_json kept{{"problem", trial.problem},          {"settings", trial.settings},
                    {"replicate", trial.replicate},      {"counts", result.counts},
                    {"failure", result.failure},         {"machine", result.machine},
                    {"cpu_seconds", result.cpu_seconds}, {"values", ordered_json::object()}};
  for (const auto& [name, value] : result.values)
    kept["values"][name] = {{"value", number_or_null(value.value)},
                            {"error", number_or_null(value.error)},
                            {"exact", number_or_null(value.exact)}};
  write_file(file, kept.dump(1) + "\n");
}

bool solve_missing(const std::vector<Trial>& trials, const TrialStore& store, const SolveOptions& options) {
  std::vector<const Trial*> missing;
  std::set<std::string> hashes;
  for (const Trial& trial : trials)
    if (!store.find(trial) && hashes.insert(trial.problem + trial.hash()).second) missing.push_back(&trial);
  const StopSignals signals;
  const WorkToSave trials_under_way;
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::size_t i = next++; i < missing.size() && !signals.requested(); i = next++) {
      try {
        const TrialResult result = solve(*missing[i]);
        store.keep(*missing[i], result);
        const std::lock_guard lock(mutex);
        ++done;
        if (options.solved) options.solved(done, missing.size(), *missing[i], result);
      } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
        next = missing.size();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int job = 0; job < options.jobs; ++job) threads.emplace_back(work);
  }
  if (error) std::rethrow_exception(error);
  return done == missing.size();
}

}  // namespace slfb::studies
