#include "solver/support/run_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace slfb {

ProgramOutcome run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           const std::string& remedy) {
  const std::string& name = words.front();
  std::array<int, 2> channel{};
  // Closed in programs that other threads start meanwhile: with a copy there, the end of this one would not be seen.
  if (pipe2(channel.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("{}: pipe: {}", name, std::strerror(errno)));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_adddup2(&actions, channel[1], STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, channel[1], STDOUT_FILENO);
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int failure = posix_spawnp(&process, name.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(channel[1]);
  if (failure != 0) {
    close(channel[0]);
    throw std::runtime_error(fmt::format("{} cannot be started: {} ({})", name, std::strerror(failure), remedy));
  }
  ProgramOutcome outcome{};
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(channel[0], buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    outcome.output.append(buffer.data(), static_cast<std::size_t>(count));
  }
  close(channel[0]);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

}  // namespace slfb
