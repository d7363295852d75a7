#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/numerics/studies/trial.hpp"

namespace slfb::studies {

/// Solved trials, a small JSON file each, named by the trial's hash: nothing is solved twice, and an interrupted study
/// goes on where it was.
class TrialStore {
 public:
  explicit TrialStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Empty where the trial was not solved, or its file is broken.
  [[nodiscard]] std::optional<TrialResult> find(const Trial& trial) const;
  /// Throws std::runtime_error that names the file if it cannot be written.
  void keep(const Trial& trial, const TrialResult& result) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(const Trial& trial) const;
  std::filesystem::path folder_;
};

struct SolveOptions {
  int jobs = 1;  ///< trials side by side, one thread each
  /// Called after each trial, by one thread at a time.
  std::function<void(std::size_t done, std::size_t all, const Trial&, const TrialResult&)> solved;
};

/// Solves those trials that the store lacks. Returns false when a signal (Ctrl-C) stopped it before the end; trials
/// that are under way are finished first. Throws what solve and TrialStore::keep throw, once all threads have ended.
bool solve_missing(const std::vector<Trial>& trials, const TrialStore& store, const SolveOptions& options);

}  // namespace slfb::studies
