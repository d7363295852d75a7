#pragma once

#include <string>

namespace slfb {

/// Model of the processor, "AMD EPYC 7B13" for instance, as /proc/cpuinfo names it; "unknown processor" where that does
/// not say. It is kept with every measured time.
std::string processor_name();

/// CPU time of the calling thread so far [s]: other threads and processes hardly change it, and it resolves
/// microseconds.
double thread_cpu_seconds();

}  // namespace slfb
