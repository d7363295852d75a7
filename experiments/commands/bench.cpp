#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/numerics/bench/coupled_bench.hpp"
#include "experiments/numerics/bench/dem_bench.hpp"
#include "experiments/numerics/bench/estimate_bench.hpp"
#include "experiments/numerics/bench/fluid_bench.hpp"
#include "experiments/numerics/pressure_noise/noise_study.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

struct DemOptions {
  std::vector<std::string> scenes{"A"};
  int threads = 1, repetitions = 5;
  std::int64_t steps = 0;
  bool json = false;
  std::string lammps_file;
};

void bench_dem(const DemOptions& options) {
  const auto say = [](const std::string& text) { fmt::print(stderr, "slfb: {}\n", text); };
  const std::filesystem::path cache = build_folder() / "bench";
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  if (!options.json && options.lammps_file.empty())
    fmt::print("{:5} {:>7} {:>16} {:>17} {:>9} {:>10} {:>10} {:>12}\n", "scene", "threads", "M particle-steps",
               "smallest, largest", "contacts", "listed", "steps per", "ns per");
  if (!options.json && options.lammps_file.empty())
    fmt::print("{:5} {:>7} {:>16} {:>17} {:>9} {:>10} {:>10} {:>12}\n", "", "", "per second", "", "/sphere", "/sphere",
               "list", "contact");
  for (const std::string& letter : options.scenes) {
    const auto& scenes = bench::dem_scenes();
    const auto scene =
        std::find_if(scenes.begin(), scenes.end(), [&](const auto& s) { return s.letter == letter.front(); });
    dem::Engine engine = bench::prepare(*scene, options.threads, cache, say);
    if (!options.lammps_file.empty()) {
      bench::write_lammps(*scene, engine, options.lammps_file);
      continue;
    }
    const auto timing =
        bench::time_dem(*scene, engine, options.repetitions, options.steps > 0 ? options.steps : scene->steps);
    const auto [least, most] = std::minmax_element(timing.rates.begin(), timing.rates.end());
    if (options.json) {
      results.push_back({{"scene", letter},
                         {"description", scene->description},
                         {"threads", timing.threads},
                         {"repetitions", timing.rates.size()},
                         {"particle_steps_per_second", timing.median_rate()},
                         {"smallest", *least},
                         {"largest", *most},
                         {"ns_per_contact", timing.nanoseconds_per_contact()},
                         {"contacts_per_particle", timing.contacts_per_particle},
                         {"pairs_per_particle", timing.pairs_per_particle},
                         {"list_builds_per_step", timing.list_builds_per_step}});
      continue;
    }
    fmt::print("{:5} {:7} {:16.2f} {:>17} {:9.2f} {:10.2f} {:10.0f} {:12.1f}\n", letter, timing.threads,
               timing.median_rate() / 1e6, fmt::format("{:.2f}, {:.2f}", *least / 1e6, *most / 1e6),
               timing.contacts_per_particle, timing.pairs_per_particle, 1.0 / timing.list_builds_per_step,
               timing.nanoseconds_per_contact());
  }
  if (options.json) fmt::print("{}\n", nlohmann::ordered_json{{"results", results}}.dump(2));
}

struct CoupledOptions {
  std::vector<std::string> cases{"water-5mm"};
  std::vector<std::string> overrides;
  int threads = 2;
  double seconds = 0.5;
  bool json = false;
};

void bench_coupled(const CoupledOptions& options) {
  const auto say = [](const std::string& text) { fmt::print(stderr, "slfb: {}\n", text); };
  const std::filesystem::path cache = build_folder() / "bench";
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const std::string& name : options.cases) {
    bench::CoupledCase chosen = bench::coupled_case(name);
    chosen.overrides.insert(chosen.overrides.end(), options.overrides.begin(), options.overrides.end());
    const bench::CoupledTiming timing =
        bench::time_coupled(bench::column_scene(chosen.overrides), options.threads, options.seconds, cache, say);
    const std::vector<std::pair<const char*, double>> stages{{"void_fraction", timing.void_fraction},
                                                             {"exchange", timing.exchange},
                                                             {"momentum", timing.momentum},
                                                             {"pressure", timing.pressure},
                                                             {"particle_motion", timing.particle_motion}};
    if (options.json) {
      nlohmann::ordered_json parts;
      for (const auto& [stage, seconds] : stages) parts[stage] = seconds / timing.simulated_seconds;
      results.push_back({{"case", name},
                         {"description", chosen.description},
                         {"threads", timing.threads},
                         {"particles", timing.particles},
                         {"cells", timing.cells},
                         {"simulated_seconds", timing.simulated_seconds},
                         {"wall_seconds_per_simulated_second", timing.wall_seconds_per_simulated_second()},
                         {"cpu_seconds_per_simulated_second", timing.cpu_seconds_per_simulated_second()},
                         {"wall_seconds_per_simulated_second_by_stage", parts},
                         {"voidage", timing.voidage},
                         {"contacts_per_particle", timing.contacts_per_particle},
                         {"pressure_iterations_per_step", timing.pressure_iterations_per_step},
                         {"continuity_error", timing.continuity_error}});
      continue;
    }
    fmt::print("{}: {}\n", name, chosen.description);
    fmt::print("  {} spheres, {} cells, {} threads, {} s simulated; voidage {:.3f}, {:.2f} contacts per sphere\n",
               timing.particles, timing.cells, timing.threads, timing.simulated_seconds, timing.voidage,
               timing.contacts_per_particle);
    fmt::print("  {:.2f} s wall and {:.2f} s of CPU per simulated second: 23 s take {:.1f} min\n",
               timing.wall_seconds_per_simulated_second(), timing.cpu_seconds_per_simulated_second(),
               timing.wall_seconds_per_simulated_second() * 23.0 / 60.0);
    for (const auto& [stage, seconds] : stages)
      fmt::print("  {:<16} {:8.2f} s {:6.1f} %\n", stage, seconds / timing.simulated_seconds,
                 100.0 * seconds / timing.wall_seconds);
    fmt::print("  pressure: {:.1f} iterations per step, continuity to {:.1e} of the inlet flow\n",
               timing.pressure_iterations_per_step, timing.continuity_error);
  }
  if (options.json) fmt::print("{}\n", nlohmann::ordered_json{{"results", results}}.dump(2));
}

struct FluidOptions {
  std::vector<int> cells_across{5, 7, 10, 14};
  std::vector<std::string> overrides;
  int threads = 1;
  std::int64_t steps = 200;
  bool json = false;
};

void bench_fluid(const FluidOptions& options) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  if (!options.json)
    fmt::print("{:>12} {:>8} {:>8} {:>10} {:>12} {:>12} {:>12} {:>14}\n", "cells across", "cells", "threads",
               "ms a step", "momentum ms", "pressure ms", "iterations", "ns a cell step");
  for (const int across : options.cells_across) {
    Overrides overrides{fmt::format("fluid.cells_across={}", across),
                        fmt::format("fluid.cell_height={} mm", 50.0 / across)};
    overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
    const auto timing = bench::time_fluid(bench::column_scene(overrides), options.threads, options.steps);
    const double per_step = 1e3 / static_cast<double>(timing.steps);
    if (options.json) {
      results.push_back({{"cells_across", across},
                         {"cells", timing.cells},
                         {"threads", timing.threads},
                         {"steps", timing.steps},
                         {"milliseconds_per_step", timing.seconds * per_step},
                         {"momentum_milliseconds_per_step", timing.momentum * per_step},
                         {"pressure_milliseconds_per_step", timing.pressure * per_step},
                         {"pressure_iterations_per_step", timing.iterations_per_step},
                         {"continuity_error", timing.continuity_error},
                         {"nanoseconds_per_cell_step", timing.nanoseconds_per_cell_step()}});
      continue;
    }
    fmt::print("{:12} {:8} {:8} {:10.2f} {:12.2f} {:12.2f} {:12.1f} {:14.0f}\n", across, timing.cells, timing.threads,
               timing.seconds * per_step, timing.momentum * per_step, timing.pressure * per_step,
               timing.iterations_per_step, timing.nanoseconds_per_cell_step());
  }
  if (options.json) fmt::print("{}\n", nlohmann::ordered_json{{"results", results}}.dump(2));
}

struct EstimateOptions {
  int repetitions = 3;
  bool json = false;
};

void bench_estimate(const EstimateOptions& options) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  if (!options.json)
    fmt::print("{:<16} {:>12} {:>12} {:>10}  {}\n", "part", "measured s", "estimated s", "ratio", "what it is");
  for (const bench::EstimatePart& part : bench::estimate_parts()) {
    const bench::EstimateTiming timing =
        bench::time_estimate(part, options.repetitions, build_folder() / "bench" / ("estimate-" + part.name));
    if (options.json)
      results.push_back({{"part", part.name},
                         {"description", part.description},
                         {"measured_cpu_seconds", timing.measured},
                         {"estimated_cpu_seconds", timing.estimated},
                         {"measured_over_estimated", timing.ratio()}});
    else
      fmt::print("{:<16} {:12.3f} {:12.3f} {:10.2f}  {}\n", part.name, timing.measured, timing.estimated,
                 timing.ratio(), part.description);
  }
  if (options.json) fmt::print("{}\n", nlohmann::ordered_json{{"results", results}}.dump(2));
}

}  // namespace

void add_bench_command(CLI::App& app) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  CLI::App* bench = app.add_subcommand("bench", "How fast the solver is on this machine");
  bench->require_subcommand(1);

  auto options = std::make_shared<DemOptions>();
  std::string scenes;
  for (const auto& scene : bench::dem_scenes()) scenes += fmt::format("\n  {}  {}", scene.letter, scene.description);
  CLI::App* dem = bench->add_subcommand(
      "dem",
      "The particle engine alone.\nLinear springs of 1e4 N/m, restitution 0.9, friction 0.3, 2230 kg/m3. The "
      "scenes:" +
          scenes);
  dem->add_option("--scene", options->scenes, "A, B, C or D; several are timed one after the other")
      ->check(CLI::IsMember({"A", "B", "C", "D"}))
      ->capture_default_str();
  dem->add_option("--threads", options->threads, "threads")->check(CLI::Range(1, cores))->capture_default_str();
  dem->add_option("--repetitions", options->repetitions, "timed repetitions; the median is reported")
      ->check(above_zero())
      ->capture_default_str();
  dem->add_option("--steps", options->steps, "steps of a repetition, if not the scene's own")->check(above_zero());
  dem->add_flag("--json", options->json, "results for programs");
  dem->add_option("--write-lammps", options->lammps_file,
                  "write the scene's start as a data file of LAMMPS and LIGGGHTS, and time nothing");
  dem->footer(
      "Example:\n  slfb bench dem --scene A C --threads 2\n\n"
      "tests/bench/compare_dem times LAMMPS and LIGGGHTS beside it.");
  dem->callback([options] { bench_dem(*options); });

  auto fluid_options = std::make_shared<FluidOptions>();
  CLI::App* fluid = bench->add_subcommand(
      "fluid",
      "The liquid alone, in a column of 50 mm on meshes of several sizes.\nA frozen bed in the lower half, uneven and "
      "changing as a coupled one is; liquid step 1e-4 s.");
  fluid->add_option("--cells-across", fluid_options->cells_across, "cells over the diameter; several are timed in turn")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  fluid->add_option("--threads", fluid_options->threads, "threads")->check(CLI::Range(1, cores))->capture_default_str();
  fluid->add_option("--steps", fluid_options->steps, "timed steps")->check(above_zero())->capture_default_str();
  fluid->add_option("--set", fluid_options->overrides,
                    "change the scene: a dotted key of the scene file and a value, as in fluid.convection=upwind");
  fluid->add_flag("--json", fluid_options->json, "results for programs");
  fluid->footer("Example:\n  slfb bench fluid --cells-across 7 14 --set fluid.time_step=1e-3");
  fluid->callback([fluid_options] { bench_fluid(*fluid_options); });

  auto coupled_options = std::make_shared<CoupledOptions>();
  CLI::App* coupled = bench->add_subcommand("coupled",
                                            "Spheres and liquid together, by stage, in a bed that is already "
                                            "fluidised.\nColumn and cases are "
                                            "experiments/numerics/bench/column.toml and cases.toml.");
  coupled->add_option("--case", coupled_options->cases, "case; several are timed one after the other")
      ->capture_default_str();
  coupled->add_option("--threads", coupled_options->threads, "threads")
      ->check(CLI::Range(1, cores))
      ->capture_default_str();
  coupled->add_option("--seconds", coupled_options->seconds, "simulated time that is timed [s]")
      ->check(above_zero())
      ->capture_default_str();
  coupled->add_option("--set", coupled_options->overrides,
                      "change the scene: a dotted key of the scene file and a value, as in fluid.time_step=1e-3");
  coupled->add_flag("--json", coupled_options->json, "results for programs");
  // The file is read only when the help is shown.
  coupled->footer([] {
    std::string text = "Cases:";
    for (const auto& one : bench::coupled_cases()) text += fmt::format("\n  {}  {}", one.name, one.description);
    return text + "\n\nExample:\n  slfb bench coupled --case water-3mm --threads 2 --set fluid.time_step=2e-4";
  });
  coupled->callback([coupled_options] {
    try {
      bench_coupled(*coupled_options);
    } catch (const std::invalid_argument& error) {  // an unknown case
      throw CLI::ValidationError(error.what());
    }
  });

  auto estimate_options = std::make_shared<EstimateOptions>();
  CLI::App* estimate = bench->add_subcommand(
      "estimate",
      "How far `slfb run --dry-run` is from what runs take on this machine: small beds in which one part of "
      "the\nsolver "
      "has most of the work, measured over estimated CPU time. A ratio of 0.7 throughout says that this\nmachine needs "
      "0.7 of each estimate. The costs that estimates take are in experiments/runs/run_estimate.hpp.");
  estimate->add_option("--repetitions", estimate_options->repetitions, "Runs of each part; the least time is reported")
      ->check(above_zero())
      ->capture_default_str();
  estimate->add_flag("--json", estimate_options->json, "Results for programs");
  estimate->callback([estimate_options] { bench_estimate(*estimate_options); });

  auto file = std::make_shared<std::string>("experiments/numerics/pressure_noise/pressure_noise.csv");
  CLI::App* noise = bench->add_subcommand(
      "pressure-noise",
      "Makes the results anew that the figure pressure-noise draws: the pressure drop of a\nfluidised bed step by "
      "step, "
      "with every void-fraction scheme at four steps of the liquid\n(some ten minutes on one core).");
  noise->add_option("--out", *file, "file to write")->capture_default_str();
  noise->callback([file] {
    noise::run_study(*file, "slfb bench pressure-noise",
                     [](const std::string& text) { fmt::print(stderr, "slfb: {}\n", text); });
  });
}

}  // namespace slfb
