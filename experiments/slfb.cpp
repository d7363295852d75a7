#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/work/work.hpp"
#include "solver/scene/scene.hpp"

namespace {

constexpr int failure_status = 1;
constexpr int usage_status = 2;

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
  slfb league                                        which laws are near to measured beds
  slfb predict scene.toml                            voidage, U_mf, pressure drop before a run, and how sure they are
  slfb list                                          what there is

`slfb COMMAND --help` explains a command.)";

/// The message for a first argument that is neither an option nor a command; empty if it is either.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "-";
  if (first.starts_with('-')) return "";
  std::string known;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->check_name(first)) return "";
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  return fmt::format("there is no command \"{}\"; the commands are {}", first, known);
}

}  // namespace

int main(int argc, char** argv) {
  // Standard output belongs to results.
  spdlog::set_default_logger(spdlog::stderr_color_mt("slfb"));
  spdlog::set_pattern("slfb: %l: %v");
  spdlog::set_level(spdlog::level::warn);

  CLI::App app(introduction(), "slfb");
  app.set_version_flag("--version", fmt::format("slfb {} (numerics version {})", SLFB_VERSION, slfb::numerics_version));
  app.require_subcommand(1);
  app.footer(examples);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("slfb: error: {}\nRun with --help for more information.\n", error.what());
  });
  try {
    slfb::add_figures_command(app);
    slfb::add_check_command(app);
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
    slfb::add_list_command(app);
    if (const std::string message = unknown_command(app, argc, argv); !message.empty()) {
      fmt::print(stderr, "slfb: error: {}\n", message);
      return usage_status;
    }
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& status) {
    return status.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_status;
  } catch (const std::exception& error) {
    fmt::print(stderr, "slfb: error: {}\n", error.what());
    return failure_status;
  }
}
