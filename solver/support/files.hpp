#pragma once

#include <filesystem>
#include <string>

namespace slfb {

/// The whole content of a file. Throws std::runtime_error that names the file if it cannot be read.
std::string read_file(const std::filesystem::path& file);

/// Replaces the content of a file, or creates it; its folder must exist. The text goes to a file beside it that is then
/// renamed, so that other processes and an interrupted program see the old file or the new one, never a part.
/// Throws std::runtime_error that names the file if it cannot be written.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace slfb
