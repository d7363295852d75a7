#pragma once

#include <filesystem>

namespace slfb {

/// Held while a process simulates in the folder of a run, so that two never write the same checkpoints: a lock on the
/// file `lock` there, opened for writing, since a network file system (NFS) locks no folder. The system lets go of it
/// however the process ends.
class RunLock {
 public:
  /// Throws std::runtime_error when another process holds it.
  explicit RunLock(const std::filesystem::path& directory);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace slfb
