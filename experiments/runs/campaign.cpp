#include "experiments/runs/campaign.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <optional>
#include <stdexcept>
#include <utility>

#include "experiments/runs/run_files.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb {

namespace {

std::optional<FinishedRun> own_run(const RunSpec& spec, const Scene& scene, const std::filesystem::path& out) {
  const std::string hash = scene_hash(scene);
  if (!std::filesystem::exists(result_file(out, hash))) return std::nullopt;
  return FinishedRun{spec, scene, load_own_result(out, hash), false, false, {}};
}

std::optional<FinishedRun> published_run(const RunSpec& spec, const Scene& scene) {
  if (spec.published.empty()) return std::nullopt;
  const auto file = published_file(spec);
  if (!std::filesystem::exists(file)) return std::nullopt;
  FinishedRun run{spec, scene, {}, true, false, {}};
  try {
    run.result = load_result(file);
    if (const auto numbers = published_summary(spec); std::filesystem::exists(numbers))
      run.summary = load_summary(numbers);
    run.stale = run.result.numerics != numerics_version || run.result.name != scene_hash(scene);
    // An older result is analysed with the scene it was made from. Its text may be anybody's: no code that it names is
    // compiled or run.
    if (run.stale) {
      const NoForeignCode guard;
      run.scene = parse_archived_scene(run.result.scene_text, file.string());
      if (is_user_law(run.scene.coupling.drag_law) || is_user_law(run.scene.contact.law))
        throw std::runtime_error(fmt::format("{}: its scene names a law from a file", file.string()));
    }
  } catch (const std::exception& error) {
    // Written by an earlier version of the suite, it may lack what this one reads.
    spdlog::warn("left out a published result: {}", error.what());
    return std::nullopt;
  }
  return run;
}

}  // namespace

std::string run_key(std::string_view system, double superficial_velocity, std::string_view variant) {
  std::string key = fmt::format("{}/{}", system, velocity_text(superficial_velocity));
  if (!variant.empty()) key += fmt::format("/{}", variant);
  return key;
}

std::string run_key(const RunSpec& spec) {
  std::string key = run_key(spec.system, spec.superficial_velocity, spec.variant);
  if (spec.seed) key += fmt::format("/seed-{}", *spec.seed);
  return key;
}

std::vector<FinishedRun> finished_runs(const Profile& profile, const std::filesystem::path& out) {
  std::vector<FinishedRun> runs;
  for (const RunSpec& spec : profile.runs) {
    const Scene scene = load_run_scene(spec);
    auto run = own_run(spec, scene, out);
    if (!run) run = published_run(spec, scene);
    if (run) runs.push_back(std::move(*run));
  }
  return runs;
}

std::vector<FinishedRun> own_runs(std::vector<FinishedRun> runs, const std::string& profile) {
  std::erase_if(runs, [&](const FinishedRun& run) { return run.published || run.spec.profile != profile; });
  return runs;
}

std::vector<FinishedRun> published_runs(const Profile& profile) {
  std::vector<FinishedRun> runs;
  for (const RunSpec& spec : profile.runs)
    if (auto run = published_run(spec, load_run_scene(spec)); run && !run->stale) runs.push_back(std::move(*run));
  return runs;
}

}  // namespace slfb
