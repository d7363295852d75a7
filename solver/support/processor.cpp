#include "solver/support/processor.hpp"

#include <fstream>

namespace slfb {

std::string processor_name() {
  std::ifstream cpu_info("/proc/cpuinfo");
  for (std::string line; std::getline(cpu_info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace slfb
