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
#include "experiments/numerics/frontier/frontier_chart.hpp"
#include "experiments/numerics/frontier/study.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;
using frontier::ReducedPoint;
using frontier::ReducedStudy;
using frontier::Study;

constexpr const char* examples =
    R"(A study repeats one problem with several methods and settings and asks each for its error and its cost. The errors are
against an exact answer, or against a run with much finer steps whose own uncertainty is drawn as a grey band. A
method that breaks down is not left out: it is a red cross at its cost, and the reason stands below the chart.

Examples:
  slfb frontier --list                        the studies, and what is computed of them
  slfb frontier                               the quick set of all studies (about 5 minutes on two cores)
  slfb frontier contact-integrators           one study
  slfb frontier --set full                    more settings, more replicates; two hours of one core, may be interrupted
  slfb frontier fluid-tier --no-run           draw what exists

Every trial is kept in DIR/trials: Ctrl-C loses nothing and no trial is computed twice. The charts lie in
DIR/frontier: frontier-STUDY.svg/.png/.pdf, a CSV per method, STUDY.json. Studies are files in
experiments/numerics/frontier/studies; a new one needs no code (experiments/numerics/frontier/README.md).)";

struct Options {
  std::vector<std::string> studies;
  std::string set = "quick";
  fs::path out = build_folder();
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bool list = false, no_run = false, publish = false;
};

std::vector<Study> chosen_studies(const Options& options) {
  const studies::Set set = studies::set_named(options.set);
  std::vector<std::string> known;
  std::vector<Study> chosen;
  for (const fs::path& file : frontier::study_files()) {
    known.push_back(file.stem().string());
    if (options.studies.empty() || std::ranges::find(options.studies, known.back()) != options.studies.end())
      chosen.push_back(frontier::load_study(file, set));
  }
  for (const std::string& id : options.studies)
    if (std::ranges::find(known, id) == known.end())
      throw CLI::ValidationError("STUDY",
                                 fmt::format("there is no study \"{}\"; known: {}", id, fmt::join(known, ", ")));
  return chosen;
}

void print_study(const Study& study, const ReducedStudy& reduced) {
  fmt::print("{}: {}\n", study.id, study.title);
  const studies::Problem& problem = studies::find_problem(study.problem);
  for (const std::string& quantity : study.quantities) {
    const auto front = frontier::pareto_front(reduced, quantity);
    if (front.empty()) continue;
    fmt::print("  {}: error, CPU s per {}, method at {}\n", studies::find_quantity(problem, quantity).title,
               problem.cost_unit, study.axis_label);
    for (const ReducedPoint* point : front)
      fmt::print("    {:9.2e}  {:9.2e}  {} at {:g}\n", point->values.at(quantity).error, point->cpu_seconds,
                 point->series, point->axis);
  }
  for (const ReducedPoint& point : reduced.points)
    if (!point.failure.empty()) fmt::print("  failed: {} at {:g}: {}\n", point.series, point.axis, point.failure);
}

int run(const Options& options) {
  const auto chosen = chosen_studies(options);
  const studies::TrialStore store(options.out / "trials");
  if (options.list) {
    fmt::print("{:<26}{:>9}{:>9}  {}\n", "study", "trials", "solved", "title");
    for (const Study& study : chosen) {
      const auto trials = frontier::trials_of(study);
      const auto solved =
          std::ranges::count_if(trials, [&](const auto& trial) { return store.find(trial).has_value(); });
      fmt::print("{:<26}{:>9}{:>9}  {}\n", study.id, trials.size(), solved, study.title);
    }
    return 0;
  }
  std::filesystem::create_directories(options.out / "frontier");
  bool whole = true;
  for (const Study& study : chosen) {
    if (!options.no_run && whole)
      whole = studies::solve_missing(
          frontier::trials_of(study), store,
          {.jobs = options.jobs, .solved = [&](std::size_t done, std::size_t all, const auto&, const auto& result) {
             fmt::print(stderr, "{}: {} of {}{}\n", study.id, done, all,
                        result.failure.empty() ? "" : ", failed: " + result.failure);
           }});
    const studies::Set set = studies::set_named(options.set);
    const bool kept = frontier::keep_if_whole(study, set, store, options.out);
    ReducedStudy reduced = frontier::reduce(study, set, store);
    if (kept && options.publish) frontier::save_reduced(reduced, frontier::committed_file(study.id));
    if (reduced.points.empty()) reduced = frontier::load_reduced(study, options.out);
    frontier::draw_frontier(study, reduced, {}, options.out / "frontier");
    print_study(study, reduced);
  }
  fmt::print("charts: {}\n", (options.out / "frontier").string());
  if (!whole) fmt::print(stderr, "Interrupted: the same command goes on where this one stopped.\n");
  return whole ? 0 : 130;
}

}  // namespace

void add_frontier_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("frontier", "Error against cost of methods, as work-precision charts");
  command->add_option("STUDY", options->studies, "studies (default: all)");
  command->add_option("--set", options->set, "how much to compute")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "folder of trials/ and frontier/")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "trials side by side, one thread each")
      ->check(above_zero())
      ->capture_default_str();
  command->add_flag("--list", options->list, "show the studies and what of them is computed");
  command->add_flag("--no-run", options->no_run, "compute nothing, draw what exists");
  command->add_flag("--publish", options->publish,
                    "write the reduced results to experiments/numerics/frontier/results too");
  command->footer(examples);
  command->callback([options] {
    if (const int status = run(*options); status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace slfb
