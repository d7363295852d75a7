#include "solver/support/child_process.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace slfb {

std::optional<std::string> trouble_in_child(const std::function<void()>& work, unsigned patience) {
  const pid_t child = fork();
  if (child < 0) return std::nullopt;  // no process is to be had: who asked goes on without this care
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) std::signal(signal, SIG_DFL);
    alarm(patience);
    try {
      work();
    } catch (...) {
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status == 0) return std::nullopt;
  if (!WIFSIGNALED(status)) return fmt::format("ends the program with status {}", WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGALRM) return fmt::format("does not end within {} s", patience);
  return fmt::format("ends with signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
}

}  // namespace slfb
