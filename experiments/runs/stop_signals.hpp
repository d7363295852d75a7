#pragma once

#include <signal.h>

#include <atomic>

namespace slfb {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP (the terminal is gone) only raises a flag, so that work can be
/// saved; a second one ends the process at once. So does the first one as long as there is nothing to save.
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
  struct sigaction previous_hang_up_ {};
};

/// Work that a stop should save; one object for each piece of it.
class WorkToSave {
 public:
  WorkToSave();
  ~WorkToSave();
  WorkToSave(const WorkToSave&) = delete;
  WorkToSave& operator=(const WorkToSave&) = delete;
};

}  // namespace slfb
