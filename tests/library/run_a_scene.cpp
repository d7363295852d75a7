// Runs a scene from C++, saves its result and reads it again: `run_a_scene scene.toml`.

#include <cstdio>
#include <exception>
#include <numeric>

#include "solver/io/run_result.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"

int main(int count, char** arguments) {
  using namespace slfb;
  if (count != 2) {
    std::fputs("usage: run_a_scene SCENE.toml\n", stderr);
    return 2;
  }
  try {
    const Scene scene = load_scene(arguments[1]);  // an error names the file, the line and the key
    RunOptions options;
    options.directory = "run_a_scene";  // of checkpoints: a run that was stopped goes on
    save_result(run_scene(scene, options).result, options.directory / "result.h5");

    const RunResult result = load_result(options.directory / "result.h5");
    const auto& pressure_drop = result.bed.pressure_drop;  // [Pa]
    const double mean =
        std::accumulate(pressure_drop.begin(), pressure_drop.end(), 0.0) / static_cast<double>(pressure_drop.size());
    std::printf("%s: %zu samples, pressure drop %.0f Pa on average\n", scene.title.c_str(), pressure_drop.size(), mean);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
