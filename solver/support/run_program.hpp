#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slfb {

/// What a program left behind.
struct ProgramOutcome {
  std::string output;  ///< its standard output and standard error as they came
  int status;          ///< exit status; 128 and the signal's number when one ended it
};

/// Runs words[0], looked up in PATH, with the other words as arguments inside `folder` and waits for its end.
/// Throws std::runtime_error when it cannot be started; `remedy` says what to do then.
ProgramOutcome run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           const std::string& remedy);

}  // namespace slfb
