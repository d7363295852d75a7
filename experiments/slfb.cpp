#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/work/work.hpp"
#include "solver/scene/scene.hpp"
#include "solver/support/close_names.hpp"
#include "solver/support/commit.hpp"
#include "solver/support/control_characters.hpp"

namespace {

constexpr int failure_status = 1;
constexpr int usage_status = 2;

/// A thread that waits for others at a barrier looks for them all the time; on a machine with other work it thereby
/// takes the core from the one it waits for, and two threads were a hundred times slower than one. So it looks for a
/// short while (some tenths of a millisecond, longer than threads with cores of their own wait) and then gives way.
/// OpenMP's library reads this before main() begins, hence a second start; where that fails the first one goes on as it
/// is.
void let_waiting_threads_give_way(char** arguments) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  if (setenv("GOMP_SPINCOUNT", "10000", 0) == 0) execv("/proc/self/exe", arguments);
}

std::string introduction() {
  std::string works;
  for (const slfb::Work* work : slfb::works()) works += fmt::format("  {}  {}\n", work->id, work->citation);
  return fmt::format(
      "slfb simulates solid-liquid fluidised beds by CFD-DEM and compares the result with the literature.\n"
      "It makes the figures of published works and says how far each is from them; it checks every claim against its\n"
      "tolerance; and it evaluates drag and contact laws beside one another.\n\nWorks:\n{}",
      works);
}

constexpr const char* examples = R"(Examples:
  slfb figures                                       simulate what is missing, draw the figures, write the report
  slfb check --json claims.json                      every claim with its verdict; fails when a gate does not hold
  slfb run experiments/scenes/fluidised_box.toml --dry-run   what one scene would cost
  slfb law gidaspow-1994 --voidage 0.5 --re 100      one law at one point
  slfb compare --drag gidaspow-1994,mine.cpp         your own law beside the literature, in formulas and simulations
  slfb show experiments/scenes/fluidised_box.toml    what a finished run holds, drawn on one page
  slfb league                                        which laws are near to measured beds
  slfb predict scene.toml                            voidage, U_mf, pressure drop before a run, and how sure they are
  slfb list                                          what there is

`slfb COMMAND --help` or `slfb help COMMAND` explains a command.)";

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The message for a first argument that is neither an option nor a command; empty if it is either.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return "";
  const auto names = command_names(app);
  if (std::ranges::find(names, words.front()) != names.end()) return "";
  return fmt::format("there is no command \"{}\"; did you mean {}? The commands are {}", words.front(),
                     slfb::close_names(words.front(), names).front(), fmt::join(names, ", "));
}

/// The nearest option to each that the command does not know; empty where all are known or none is near.
std::string suggestions(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<const CLI::App*> asked{&app};
  for (const CLI::App* command : app.get_subcommands({}))
    if (!words.empty() && command->get_name() == words.front()) asked.push_back(command);
  std::vector<std::string> known;
  for (const CLI::App* of : asked)
    for (const CLI::Option* option : of->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  std::string text;
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (name.starts_with("--") && name.size() > 2 && std::ranges::find(known, name) == known.end())
      text += slfb::did_you_mean(name, known);
  }
  return text;
}

/// Messages: warnings and progress, only errors with -q, more with -v. They have colours on a terminal, unless NO_COLOR
/// is set (no-color.org).
void set_up_messages() {
  const char* no_color = std::getenv("NO_COLOR");
  const auto mode =
      no_color != nullptr && *no_color != '\0' ? spdlog::color_mode::never : spdlog::color_mode::automatic;
  // Standard output belongs to results.
  spdlog::set_default_logger(spdlog::stderr_color_mt("slfb", mode));
  spdlog::set_pattern("slfb: %^%l%$: %v");
  spdlog::set_level(spdlog::level::warn);
}

/// A message as a terminal may show it: texts of broken files can hold any byte, also those that steer a terminal.
std::string printable(std::string_view text) {
  std::string shown;
  for (const char letter : text) {
    shown += slfb::is_control_character(letter) ? fmt::format("\\x{:02x}", static_cast<unsigned char>(letter))
                                                : std::string(1, letter);
  }
  return shown;
}

}  // namespace

int main(int argc, char** argv) try {
  let_waiting_threads_give_way(argv);
  set_up_messages();
  std::vector<std::string> words(argv + 1, argv + argc);
  // "slfb" and "slfb help COMMAND" are asked in good faith: they get the help.
  if (words.empty()) words = {"--help"};
  if (words.front() == "help") {
    words.erase(words.begin());
    if (words.empty() || words.front() != "--help") words.resize(words.empty() ? 0 : 1);
    words.emplace_back("--help");
  }

  CLI::App app(introduction(), "slfb");
  app.set_version_flag("--version", fmt::format("slfb {}\ncommit {}, numerics version {}", SLFB_VERSION,
                                                slfb::suite_commit(), slfb::numerics_version));
  app.require_subcommand(1);
  app.footer(examples);
  app.failure_message([&](const CLI::App*, const CLI::Error& error) {
    const auto names = command_names(app);
    const bool of_command = !words.empty() && std::ranges::find(names, words.front()) != names.end();
    return fmt::format("slfb: error: {}{}\n`slfb {}--help` explains it.\n", error.what(), suggestions(app, words),
                       of_command ? words.front() + " " : "");
  });
  app.add_flag_callback(
      "-q,--quiet", [] { spdlog::set_level(spdlog::level::err); }, "no warnings, no progress");
  app.add_flag_callback(
      "-v,--verbose", [] { spdlog::set_level(spdlog::level::info); }, "say more of what is done");
  try {
    slfb::add_figures_command(app);
    slfb::add_check_command(app);
    slfb::add_history_command(app);
    slfb::add_article_command(app);
    slfb::add_compare_command(app);
    slfb::add_run_command(app);
    slfb::add_plan_command(app);
    slfb::add_frontier_command(app);
    slfb::add_stability_command(app);
    slfb::add_league_command(app);
    slfb::add_predict_command(app);
    slfb::add_laws_command(app);
    slfb::add_law_command(app);
    slfb::add_bench_command(app);
    slfb::add_campaign_command(app);
    slfb::add_show_command(app);
    slfb::add_movie_command(app);
    slfb::add_list_command(app);
    slfb::add_completion_command(app);
    for (CLI::App* command : app.get_subcommands({})) command->fallthrough();  // -q and -v behind a command
    if (const std::string message = unknown_command(app, words); !message.empty()) {
      fmt::print(stderr, "slfb: error: {}\n", message);
      return usage_status;
    }
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // what CLI11 expects
    app.parse(reversed);
    return 0;
  } catch (const CLI::RuntimeError& status) {
    return status.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_status;
  }
} catch (const std::exception& error) {
  fmt::print(stderr, "slfb: error: {}\n", printable(error.what()));
  return failure_status;
}
