#include "experiments/commands/report_inputs.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <set>

#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// Name, size and time of a file.
std::string state_of(const fs::path& file) {
  std::error_code missing;
  return fmt::format("{} {} {}\n", file.string(), fs::file_size(file, missing),
                     fs::last_write_time(file, missing).time_since_epoch().count());
}

}  // namespace

std::string report_inputs(const std::string& work, const std::string& profile, const fs::path& out) {
  std::set<std::string> lines{work + " " + profile + "\n", state_of(fs::read_symlink("/proc/self/exe"))};
  for (const char* room : {"experiments", "reference-data", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / room))
      if (entry.is_regular_file()) lines.insert(state_of(entry.path()));
  if (fs::is_directory(out / "runs"))
    for (const auto& entry : fs::directory_iterator(out / "runs"))
      if (fs::exists(entry.path() / "result.h5")) lines.insert(state_of(entry.path() / "result.h5"));
  // These are written again at each call: their text says whether they are new.
  for (const char* studies : {"frontier", "stability"})
    if (fs::is_directory(out / studies))
      for (const auto& entry : fs::directory_iterator(out / studies))
        if (entry.path().extension() == ".json") lines.insert(entry.path().string() + read_file(entry.path()));
  std::string text;
  for (const std::string& line : lines) text += line;
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

}  // namespace slfb
