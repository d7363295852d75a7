#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/numerics/stability/map.hpp"
#include "experiments/numerics/stability/map_chart.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;
using stability::Boundary;
using stability::BoundaryKind;
using stability::Map;
using stability::SolvedMap;

constexpr const char* examples =
    R"(A map looks for the boundary between settings with which a method holds and settings with which it fails, by bisection
on a criterion stated in physics: motion that must die out grows, energy that must be conserved is not, a cell gets
more solid than it has room for, a solver gives up. The limit that theory gives is drawn beside it.

Examples:
  slfb stability --list                     the maps and their criteria
  slfb stability                            the quick set of all maps (about 5 minutes on two cores)
  slfb stability contact-pair packing-step  two maps
  slfb stability --set full                 more points
  slfb stability --no-run                   draw what exists

Every trial is kept in DIR/trials: Ctrl-C loses nothing. The maps lie in DIR/stability: stability-MAP.svg/.png/.pdf, a CSV
per method, MAP.json with brackets and diagnoses. Maps are files in experiments/numerics/stability/maps; a new one needs no code
(experiments/numerics/stability/README.md).)";

struct Options {
  std::vector<std::string> maps;
  std::string set = "quick";
  fs::path out = build_folder();
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bool list = false, no_run = false, publish = false;
};

std::vector<Map> chosen_maps(const Options& options) {
  std::vector<std::string> known;
  std::vector<Map> chosen;
  for (const fs::path& file : stability::map_files()) {
    known.push_back(file.stem().string());
    if (options.maps.empty() || std::ranges::find(options.maps, known.back()) != options.maps.end())
      chosen.push_back(stability::load_map(file, studies::set_named(options.set)));
  }
  for (const std::string& id : options.maps)
    if (std::ranges::find(known, id) == known.end())
      throw CLI::ValidationError("MAP", fmt::format("there is no map \"{}\"; known: {}", id, fmt::join(known, ", ")));
  return chosen;
}

void print_map(const Map& map, const SolvedMap& solved) {
  fmt::print("{}: {}\n  fails: {}\n", map.id, map.title, map.criterion_text);
  fmt::print("  {:<30}{:>12}{:>26}", "method", "x", "boundary");
  for (const auto& theory : map.theories) fmt::print("{:>34}", theory.name);
  fmt::print("\n");
  for (const Boundary& b : solved.boundaries) {
    const std::string text = b.kind == BoundaryKind::never_fails ? fmt::format("holds to {:.3g}", b.y)
                             : b.kind == BoundaryKind::always_fails
                                 ? fmt::format("fails from {:.3g}", b.y)
                                 : fmt::format("{:.4g} +- {:.1f} %", b.y, 50.0 * (b.high / b.low - 1.0));
    fmt::print("  {:<30}{:>12.4g}{:>26}", b.series, b.x, text);
    for (const double value : b.theory) fmt::print("{:>34.4g}", value);
    fmt::print("\n");
  }
}

int run(const Options& options) {
  const auto chosen = chosen_maps(options);
  if (options.list) {
    for (const Map& map : chosen)
      fmt::print("{:<22}{}\n{:<22}  fails: {}\n", map.id, map.title, "", map.criterion_text);
    return 0;
  }
  std::filesystem::create_directories(options.out / "stability");
  bool whole = true;
  for (const Map& map : chosen) {
    SolvedMap solved;
    if (!options.no_run && whole) {
      stability::MapAnswer answer = stability::solve_map(
          map, studies::set_named(options.set), options.out, options.jobs, [&](const Boundary& found) {
            fmt::print(stderr, "{}: {} at {:g}: {:.4g}\n", map.id, found.series, found.x, found.y);
          });
      whole = answer.whole;
      solved = std::move(answer.solved);
      if (options.publish && whole) stability::save_solved(solved, stability::committed_file(map.id));
    } else {
      solved = stability::load_solved(map, options.out);
    }
    stability::draw_map(map, solved, {}, options.out / "stability");
    print_map(map, solved);
  }
  fmt::print("maps: {}\n", (options.out / "stability").string());
  if (!whole) fmt::print(stderr, "Interrupted: the same command goes on where this one stopped.\n");
  return whole ? 0 : 130;
}

}  // namespace

void add_stability_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("stability", "Maps of where methods fail, with the limits of theory");
  command->add_option("MAP", options->maps, "maps (default: all)");
  command->add_option("--set", options->set, "how much to compute")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "folder of trials/ and stability/")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "trials side by side, one thread each")
      ->check(above_zero())
      ->capture_default_str();
  command->add_flag("--list", options->list, "show the maps and their criteria");
  command->add_flag("--no-run", options->no_run, "compute nothing, draw what exists");
  command->add_flag("--publish", options->publish,
                    "write the boundaries to experiments/numerics/stability/results too");
  command->footer(examples);
  command->callback([options] {
    if (const int status = run(*options); status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
