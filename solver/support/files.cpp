#include "solver/support/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace slfb {
namespace {

namespace fs = std::filesystem;

std::runtime_error failure(const fs::path& file, std::string_view problem, std::string_view reason) {
  return std::runtime_error(fmt::format("{}: {}: {}", file.string(), problem, reason));
}

void write_in_place(const fs::path& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw failure(file, "cannot be written", errno != 0 ? std::strerror(errno) : "the stream failed");
}

}  // namespace

std::string read_file(const fs::path& file) {
  if (fs::is_directory(file)) throw failure(file, "cannot be read", "is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw failure(file, "cannot be read", std::strerror(errno));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw failure(file, "cannot be read", "the stream failed");
  return text;
}

void write_file(const fs::path& file, const std::string& text) {
  // A device or a pipe (/dev/stdout) is written to, not replaced.
  if (fs::exists(file) && !fs::is_regular_file(file)) return write_in_place(file, text);
  const fs::path target = fs::is_symlink(file) ? fs::weakly_canonical(file) : file;
  static std::atomic<unsigned> count{0};  // threads may write the same file
  const fs::path unfinished = fmt::format("{}.{}-{}", target.string(), getpid(), count++);
  try {
    write_in_place(unfinished, text);
    fs::rename(unfinished, target);
  } catch (...) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw;
  }
}

}  // namespace slfb
