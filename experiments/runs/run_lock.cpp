#include "experiments/runs/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace slfb {

RunLock::RunLock(const std::filesystem::path& directory)
    : descriptor_(open((directory / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), directory.string());
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  close(descriptor_);
  // A file system without locks is no reason not to simulate.
  descriptor_ = -1;
  if (reason == EWOULDBLOCK)
    throw std::runtime_error(
        fmt::format("another slfb simulates this scene in {}; its result will lie there, or choose another --out",
                    directory.string()));
}

RunLock::~RunLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace slfb
