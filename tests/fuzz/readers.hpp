#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Every reader of the suite as a function of one input, for fuzzing (README.md).
namespace slfb::fuzz {

struct Reader {
  std::string name;                ///< "scene"
  std::vector<std::string> seeds;  ///< valid inputs to start from
  /// Reads an input; `folder` is empty and may be written in. Whatever is wrong with the input has to come as a
  /// std::runtime_error whose text names the input.
  std::function<void(const std::string& input, const std::filesystem::path& folder)> read;
};

/// All readers. Their seeds are made and read when they are asked for.
std::vector<Reader> readers();

/// One input for one reader. Empty if it was read or refused well, else what happened: another exception, or one that
/// does not say of which input it speaks.
std::string fault_of(const Reader& reader, const std::string& input, const std::filesystem::path& folder);

}  // namespace slfb::fuzz
