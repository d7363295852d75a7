#pragma once

#include <ctime>

namespace slfb::studies {

/// CPU time of the calling thread [s]: what others do beside it hardly counts, and it resolves microseconds.
inline double thread_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace slfb::studies
