#include "experiments/work/certificate.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "solver/support/commit.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/processor.hpp"
#include "solver/support/run_program.hpp"

namespace slfb {
namespace {

/// Packages of the group "build" of .ci/packages.txt.
std::vector<std::string> needed_packages() {
  std::ifstream stream(source_folder() / ".ci" / "packages.txt");
  std::vector<std::string> names;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    if (std::string group, name; words >> group >> name && group == "build") names.push_back(name);
  }
  return names;
}

/// Names and versions of those that are installed; none where there is no dpkg.
std::vector<std::pair<std::string, std::string>> installed(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::string>> found;
  if (names.empty()) return found;
  std::vector<std::string> words{"dpkg-query", "-W", "-f", "${Package} ${Version}\\n"};
  words.insert(words.end(), names.begin(), names.end());
  try {
    std::istringstream lines(run_program(words, ".", "").output);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream parts(line);
      std::string name, version, more;
      // Other lines are messages on packages that are not there.
      if (parts >> name >> version && !(parts >> more)) found.emplace_back(name, version);
    }
  } catch (const std::runtime_error&) {
    // Another kind of system: the certificate goes without.
  }
  return found;
}

std::string system_name() {
  std::ifstream stream("/etc/os-release");
  constexpr std::string_view key = "PRETTY_NAME=\"";
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(key) && line.ends_with('"')) return line.substr(key.size(), line.size() - key.size() - 1);
  return "";
}

}  // namespace

reports::Certificate certificate() {
  return {suite_commit(), fmt::format("{}, {} cores", processor_name(), std::thread::hardware_concurrency()),
          system_name(), installed(needed_packages())};
}

}  // namespace slfb
