#include "experiments/numerics/bench/estimate_bench.hpp"

#include <algorithm>
#include <limits>

#include "experiments/runs/run_estimate.hpp"
#include "solver/run/simulation.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::bench {

std::vector<EstimatePart> estimate_parts() {
  const auto file = source_folder() / "experiments/numerics/bench/estimate_parts.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  const Overrides common = table.texts("set");
  std::vector<EstimatePart> parts;
  for (TomlTable& one : table.tables("part")) {
    parts.push_back({one.text("name"), one.text("description"), common});
    for (const std::string& setting : one.texts("set")) parts.back().overrides.push_back(setting);
    one.reject_others();
  }
  table.reject_others();
  return parts;
}

EstimateTiming time_estimate(const EstimatePart& part, int repetitions, const std::filesystem::path& folder) {
  const Scene scene = load_scene(source_folder() / "experiments/numerics/studies/scenes/box.toml", part.overrides);
  EstimateTiming timing{std::numeric_limits<double>::infinity(), estimate_run(scene).core_seconds};
  for (int k = 0; k < repetitions; ++k) {
    std::filesystem::remove_all(folder);
    timing.measured = std::min(timing.measured, run_scene(scene, {.directory = folder}).result.cpu_seconds);
  }
  std::filesystem::remove_all(folder);
  return timing;
}

}  // namespace slfb::bench
