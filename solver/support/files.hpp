#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace slfb {

/// The whole content of a regular file. Throws std::runtime_error that names the file if it cannot be read or if it is
/// of another kind: a pipe or a device may have no end.
std::string read_file(const std::filesystem::path& file);

/// Whether a file that has been written survives a power failure; that takes milliseconds.
enum class Durability { cache, disk };

/// Replaces a file of an output folder, or creates it; the folder must exist. The text goes to a file beside it,
/// NAME.<process>-<n>.part, that is then renamed: other processes and an interrupted program see the old file or the
/// new one, never a part. A link at that name is replaced, not followed: who else may write in the folder cannot lead
/// the text elsewhere. Throws std::runtime_error that names the file and the system's reason if it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view text);
/// The same for content that comes in parts.
void write_file(const std::filesystem::path& file, std::initializer_list<std::string_view> parts,
                Durability durability);

/// The same for a file that a user has named, "--json FILE": links are followed, and a device or a pipe (/dev/stdout)
/// is written to.
void write_named_file(const std::filesystem::path& file, std::string_view text);

/// Makes a folder for output, with those above it. Throws std::runtime_error if it cannot be made, or if a link stands
/// at its name: what is written there would land where the link leads.
void make_output_folder(const std::filesystem::path& folder);

/// Whether a text can be part of a file's name: letters, digits, '-', '_', '.', '=', '+' and ',', and no point at its
/// start. Nothing else, such as "../x", may come from a data file into a path.
bool is_plain_name(std::string_view text);

/// Removes what write_file left unfinished in a folder when its process was killed. A folder that does not exist, and
/// files of processes that still run, are left alone.
void remove_unfinished(const std::filesystem::path& folder);

}  // namespace slfb
