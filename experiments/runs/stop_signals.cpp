#include "experiments/runs/stop_signals.hpp"

namespace slfb {
namespace {

std::atomic<bool> stop_requested{false};
std::atomic<int> pieces_to_save{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may only use lock-free atomics");

void handle(int number) {
  stop_requested = true;
  // The handler is reset: the same signal, raised again, has its usual effect when this function returns.
  if (pieces_to_save == 0) raise(number);
}

}  // namespace

StopSignals::StopSignals() {
  stop_requested = false;
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second signal has its usual effect
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &previous_interrupt_);
  sigaction(SIGTERM, &action, &previous_terminate_);
  sigaction(SIGHUP, nullptr, &previous_hang_up_);
  // Who starts a run with nohup wants it to go on.
  if (previous_hang_up_.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &previous_interrupt_, nullptr);
  sigaction(SIGTERM, &previous_terminate_, nullptr);
  sigaction(SIGHUP, &previous_hang_up_, nullptr);
}

const std::atomic<bool>& StopSignals::requested() const { return stop_requested; }

WorkToSave::WorkToSave() { ++pieces_to_save; }
WorkToSave::~WorkToSave() { --pieces_to_save; }

}  // namespace slfb
