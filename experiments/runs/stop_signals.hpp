#pragma once

#include <signal.h>

#include <atomic>

namespace slfb {

/// While it lives, the first SIGINT or SIGTERM only raises a flag, so that runs can save their state; a second one ends
/// the process at once.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] const std::atomic<bool>& requested() const;

 private:
  struct sigaction previous_interrupt_ {};
  struct sigaction previous_terminate_ {};
};

}  // namespace slfb
