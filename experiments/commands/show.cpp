#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/commands/above_zero.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/works.hpp"
#include "experiments/figures/run_page.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/io/hdf5_file.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/run_program.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr const char* show_examples = R"(Examples:
  slfb show experiments/scenes/fluidised_box.toml   the result of this scene
  slfb show 26c937eb                                the run whose hash begins so
  slfb show result.h5 --only-print                  what the file holds; nothing is drawn

The page is DIR/show/HASH/index.html: heights, pressure drop, fall, forces, voidage, spheres, each with its CSV and the
gnuplot script that redraws it. Snapshots for ParaView lie in the run's folder, if the scene asked for them
(recording.snapshot_interval): open particles.hdf.series and liquid.hdf.series.)";

constexpr const char* movie_examples = R"(Examples:
  slfb movie 26c937eb                      frames of the spheres, and movie.mp4 where ffmpeg is installed
  slfb run scene.toml --set "recording.snapshot_interval=0.02 s"     a run with 50 pictures per second of the bed

Without snapshots of its own a run has the few moments that its result keeps. The frames lie in DIR/show/HASH/frames.)";

struct Options {
  std::string run;
  fs::path out = build_folder();
  bool only_print = false;
  int frames_per_second = 25;
};

struct FoundRun {
  fs::path file, folder;
  RunResult result;
  Scene scene;
};

/// The hash in `out`/runs that begins so.
fs::path folder_of_hash(const std::string& name, const fs::path& out) {
  std::vector<fs::path> found;
  std::size_t all = 0;
  if (fs::is_directory(out / "runs"))
    for (const auto& entry : fs::directory_iterator(out / "runs")) {
      if (!fs::exists(entry.path() / "result.h5")) continue;
      ++all;
      if (entry.path().filename().string().starts_with(name)) found.push_back(entry.path());
    }
  if (found.size() == 1) return found.front();
  throw std::runtime_error(
      found.empty() ? fmt::format("no file, folder or finished run is called \"{}\"; {} holds {} finished runs", name,
                                  (out / "runs").string(), all)
                    : fmt::format("{} runs begin with \"{}\"; give more letters", found.size(), name));
}

fs::path result_of(const std::string& name, const fs::path& out) {
  if (name.ends_with(".toml")) {
    const fs::path file = result_file(out, scene_hash(load_scene(name)));
    if (fs::exists(file)) return file;
    throw std::runtime_error(
        fmt::format("the scene {0} has no result in {1}; `slfb run {0}` simulates it", name, (out / "runs").string()));
  }
  if (fs::is_directory(name) && fs::exists(fs::path(name) / "result.h5")) return fs::path(name) / "result.h5";
  if (fs::is_regular_file(name)) return name;
  return folder_of_hash(name, out) / "result.h5";
}

FoundRun find(const Options& options) {
  FoundRun found;
  found.file = result_of(options.run, options.out);
  found.folder = found.file.parent_path();
  found.result = load_result(found.file);
  found.scene = parse_scene(found.result.scene_text, found.file.string());
  return found;
}

/// The window and clock of the work whose scenes have the title of this one; the general ones where there is none.
const MeasuringRules& rules_of(const Options& options) {
  const auto folder = fs::weakly_canonical(options.run).parent_path();
  for (const Work* work : works())
    if (folder == work->folders.experiments / "scenes" || folder.string().starts_with(work->folders.published.string()))
      return work->measuring;
  return general_rules();
}

void print(const FoundRun& found) {
  const RunResult& result = found.result;
  const auto line = [](const char* name, const std::string& text) { fmt::print("  {:<18} {}\n", name, text); };
  fmt::print("{}\n", found.file.string());
  if (!found.scene.title.empty()) line("title", found.scene.title);
  line("hash", result.name);
  line("made by", fmt::format("slfb {}{}, numerics version {}, {}", result.suite_version,
                              result.commit.empty() ? "" : " commit " + result.commit, result.numerics, result.date));
  line("machine", fmt::format("{}, {} thread{}", result.machine, result.threads, result.threads == 1 ? "" : "s"));
  line("simulated", fmt::format("{:.2f} s in {}", result.simulated_seconds, format_duration(result.wall_seconds)));
  line("packed bed", fmt::format("voidage {:.4f}, height {:.4f} m", result.packed_voidage, result.packed_height));
  for (std::size_t i = 0; i < result.drops.size(); ++i) {
    const DropSeries& drop = result.drops[i];
    line(i == 0 ? "drops" : "",
         fmt::format(
             "{}, released at {:.2f} s, {}", drop.species, drop.release_time,
             drop.bottom_time < 0.0 ? "bottom not reached" : fmt::format("bottom after {:.3g} s", drop.bottom_time)));
  }
  const auto file = io::Hdf5File::open(found.file);
  fmt::print("\n  {:<40} {:>9}  {:<8} {}\n", "data set", "values", "unit", "what it is");
  for (const ResultDataSet& set : result_data_sets()) {
    if (!file.exists(set.path)) continue;
    std::size_t values = 1;
    for (const std::size_t extent : file.shape(set.path)) values *= extent;
    fmt::print("  {:<40} {:>9}  {:<8} {}\n", set.path, values, set.unit, set.description);
  }
}

void show(const Options& options) {
  const FoundRun found = find(options);
  print(found);
  if (options.only_print) return;
  const fs::path page =
      write_run_page(found.scene, found.result, rules_of(options), options.out / "show" / found.result.name);
  fmt::print("\npage: {}\n", page.string());
}

void make_movie(const Options& options) {
  const FoundRun found = find(options);
  const auto snapshots = snapshots_of(found.result, found.folder);
  if (snapshots.empty())
    throw std::runtime_error(
        fmt::format("{} holds no positions of spheres; run its scene with --set "
                    "\"recording.snapshot_interval=0.02 s\"",
                    found.file.string()));
  const fs::path folder = options.out / "show" / found.result.name / "frames";
  fs::remove_all(folder);
  const std::size_t frames = draw_frames(found.scene, snapshots, folder);
  fmt::print("{} frames: {}\n", frames, folder.string());
  const fs::path movie = folder.parent_path() / "movie.mp4";
  try {
    const auto [message, status] = run_program(
        {"ffmpeg", "-y", "-loglevel", "error", "-framerate", fmt::format("{}", options.frames_per_second), "-i",
         "frame_%04d.png", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", fs::absolute(movie).string()},
        folder, "apt-get install ffmpeg");
    if (status != 0) throw std::runtime_error(fmt::format("ffmpeg failed:\n{}", message));
    fmt::print("movie: {}\n", movie.string());
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "no movie, only its frames: {}\n", error.what());
  }
}

}  // namespace

void add_show_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("show", "What a finished run holds, printed, and drawn on one page");
  command->add_option("RUN", options->run, "a result file, the folder or hash of a run, or a scene file")
      ->required()
      ->option_text("RUN|HASH|SCENE");
  command->add_option("--out", options->out, "folder of runs/ and show/")->option_text("DIR");
  command->add_flag("--only-print", options->only_print, "draw nothing");
  command->footer(show_examples);
  command->callback([options] { show(*options); });
}

void add_movie_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("movie", "Pictures of the spheres of a run, and a film of them");
  command->add_option("RUN", options->run, "a result file, the folder or hash of a run, or a scene file")
      ->required()
      ->option_text("RUN|HASH|SCENE");
  command->add_option("--rate", options->frames_per_second, "frames per second of the film")
      ->check(above_zero())
      ->capture_default_str();
  command->add_option("--out", options->out, "folder of runs/ and show/")->option_text("DIR");
  command->footer(movie_examples);
  command->callback([options] { make_movie(*options); });
}

}  // namespace slfb
