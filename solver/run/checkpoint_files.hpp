#pragma once

#include <filesystem>
#include <string>

#include "solver/io/run_result.hpp"
#include "solver/io/state_group.hpp"

namespace slfb::simulation {

/// The files from which an interrupted run goes on, in the directory of the run: checkpoint.h5 holds the state,
/// records_<n>.h5 what was recorded until then. failure.h5 is a state after a breakdown, for a look at it.
class CheckpointFiles {
 public:
  /// \param scene_hash of the run; a checkpoint of another scene is not read
  CheckpointFiles(std::filesystem::path directory, std::string scene_hash)
      : directory_(std::move(directory)), scene_hash_(std::move(scene_hash)) {}

  /// Replaces the checkpoint. A crash at any moment leaves the old or the new one, with its own records. Throws
  /// std::runtime_error if a file cannot be written. `number`: differs from checkpoint to checkpoint of a run.
  void save(const RunResult& result, std::int64_t number, const io::StateGroup::Exchange& state) const;

  /// Reads state and records; false, and nothing changed, if there is no checkpoint of this scene. Throws
  /// std::runtime_error that says how to start anew if the checkpoint is damaged or of an earlier version.
  bool load(RunResult& result, const io::StateGroup::Exchange& state) const;

  /// Writes failure.h5 and returns its path.
  std::filesystem::path save_failure(const io::StateGroup::Exchange& state) const;

  /// Removes the files of all checkpoints and failures in a directory of a run.
  static void remove(const std::filesystem::path& directory);

 private:
  [[nodiscard]] std::filesystem::path checkpoint() const { return directory_ / "checkpoint.h5"; }
  void write(const std::filesystem::path& file, const std::string& records,
             const io::StateGroup::Exchange& state) const;

  std::filesystem::path directory_;
  std::string scene_hash_;
};

}  // namespace slfb::simulation
