#include "solver/support/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view unfinished_ending = ".part";
/// Files that are written from now on are not older than this: their times are those of a coarser clock.
const auto program_start = fs::file_time_type::clock::now() - std::chrono::seconds(1);

std::runtime_error failure(const fs::path& file, std::string_view problem, std::string_view reason) {
  return std::runtime_error(fmt::format("{}: {}: {}", file.string(), problem, reason));
}

std::runtime_error write_failure(const fs::path& file, int error) {
  return failure(file, "cannot be written", std::strerror(error));
}

/// An open file, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  /// Some file systems report a full disk only now.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

/// `file` is named in errors.
void write_all(Descriptor& target, const fs::path& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(target.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw write_failure(file, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// The process in NAME.<process>-<n>.part; none for another name.
std::optional<pid_t> writer_of(std::string_view name) {
  if (!name.ends_with(unfinished_ending)) return std::nullopt;
  name.remove_suffix(unfinished_ending.size());
  const auto dash = name.rfind('-'), point = name.rfind('.');
  if (dash == name.npos || point == name.npos || dash < point) return std::nullopt;
  const auto all_digits = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  };
  const std::string_view process = name.substr(point + 1, dash - point - 1);
  pid_t number = 0;
  if (!all_digits(process) || !all_digits(name.substr(dash + 1)) ||
      std::from_chars(process.data(), process.data() + process.size(), number).ec != std::errc() || number <= 0)
    return std::nullopt;
  return number;
}

}  // namespace

std::string read_file(const fs::path& file) {
  const auto cannot = [&](std::string_view reason) { return failure(file, "cannot be read", reason); };
  // Opening a pipe would wait for somebody who writes into it.
  const Descriptor source(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (source.number() < 0) throw cannot(std::strerror(errno));
  struct stat status {};
  if (::fstat(source.number(), &status) != 0) throw cannot(std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw cannot("is a folder");
  if (!S_ISREG(status.st_mode)) throw cannot("is no regular file");
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t length = 0;
  std::array<char, 4096> more{};  // files of /proc have no size, and others may grow
  for (;;) {
    const bool beyond = length == text.size();
    const ssize_t count = beyond ? ::read(source.number(), more.data(), more.size())
                                 : ::read(source.number(), text.data() + length, text.size() - length);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw cannot(std::strerror(errno));
    if (beyond) text.append(more.data(), static_cast<std::size_t>(count));
    length += static_cast<std::size_t>(count);
    if (count > 0) continue;
    text.resize(length);
    return text;
  }
}

void write_file(const fs::path& file, std::initializer_list<std::string_view> parts, Durability durability) {
  static std::atomic<unsigned> count{0};  // threads may write the same file
  const std::string unfinished = fmt::format("{}.{}-{}{}", file.string(), getpid(), count++, unfinished_ending);
  Descriptor target(::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (target.number() < 0) throw write_failure(file, errno);
  try {
    for (const std::string_view part : parts) write_all(target, file, part);
    if (durability == Durability::disk && ::fsync(target.number()) != 0 && errno != EINVAL)
      throw write_failure(file, errno);
    if (!target.close()) throw write_failure(file, errno);
    if (::rename(unfinished.c_str(), file.c_str()) != 0) throw write_failure(file, errno);
  } catch (...) {
    ::unlink(unfinished.c_str());
    throw;
  }
}

void write_file(const fs::path& file, std::string_view text) { write_file(file, {text}, Durability::cache); }

void write_named_file(const fs::path& file, std::string_view text) {
  const fs::path target = fs::is_symlink(file) ? fs::weakly_canonical(file) : file;
  if (!fs::exists(target) || fs::is_regular_file(target)) return write_file(target, text);
  Descriptor stream(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
  if (stream.number() < 0) throw write_failure(file, errno);
  write_all(stream, file, text);
}

void make_output_folder(const fs::path& folder) {
  if (fs::is_symlink(folder))
    throw std::runtime_error(
        fmt::format("{}: is a link; slfb makes this folder itself and writes through no link, so "
                    "remove it, or choose another --out",
                    folder.string()));
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::runtime_error(fmt::format("{}: this folder cannot be made: {}", folder.string(), error.message()));
}

bool is_plain_name(std::string_view text) {
  constexpr std::string_view others = "-_.=+,";
  return !text.starts_with('.') && std::ranges::all_of(text, [&](unsigned char c) {
    return (c < 128 && std::isalnum(c) != 0) || others.find(static_cast<char>(c)) != others.npos;
  });
}

void remove_unfinished(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const auto process = writer_of(entry.path().filename().string());
    if (!process || !entry.is_regular_file(ignored)) continue;
    // A number is used again: in a container that starts anew even the own one.
    const bool over = *process == getpid() ? entry.last_write_time(ignored) < program_start
                                           : ::kill(*process, 0) != 0 && errno == ESRCH;
    if (over) fs::remove(entry.path(), ignored);
  }
}

}  // namespace slfb
