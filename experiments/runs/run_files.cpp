#include "experiments/runs/run_files.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "solver/laws/user_law.hpp"
#include "solver/support/files.hpp"

namespace slfb {

Scene load_run_scene(const RunSpec& spec) { return load_scene(spec.scene, spec.overrides); }

std::filesystem::path run_directory(const std::filesystem::path& out, const std::string& hash) {
  return out / "runs" / hash;
}

std::filesystem::path result_file(const std::filesystem::path& out, const std::string& hash) {
  return run_directory(out, hash) / "result.h5";
}

RunResult load_own_result(const std::filesystem::path& out, const std::string& hash) {
  try {
    RunResult result = load_result(result_file(out, hash));
    if (result.name != hash)
      throw std::runtime_error(
          fmt::format("{}: is the result of another scene, {}", result_file(out, hash).string(), result.name));
    return result;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}; remove it to have it simulated again", error.what()));
  }
}

namespace {

std::filesystem::path published(const RunSpec& spec, const char* ending) {
  std::string variant = spec.variant.empty() ? "default" : spec.variant;
  for (const std::string& part : {spec.profile, spec.system, variant})
    if (!is_plain_name(part)) throw std::runtime_error(fmt::format("\"{}\" cannot be part of a file's name", part));
  if (spec.seed) variant += fmt::format("_seed-{}", *spec.seed);
  return spec.published / spec.profile /
         fmt::format("{}_{}_{}{}", spec.system, velocity_text(spec.superficial_velocity), variant, ending);
}

/// Keeps every `stride`-th value and the last one.
void thin(std::vector<double>& values, std::size_t stride) {
  if (values.empty()) return;
  const double last = values.back();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); i += stride) values[kept++] = values[i];
  const bool ends = (values.size() - 1) % stride == 0;
  values.resize(kept);
  if (!ends) values.push_back(last);
}

}  // namespace

std::filesystem::path published_file(const RunSpec& spec) { return published(spec, ".h5"); }
std::filesystem::path published_summary(const RunSpec& spec) { return published(spec, ".json"); }

void publish_result(const RunSpec& spec, const RunResult& result, bool whole, const MeasuringRules& rules) {
  const auto file = published_file(spec);
  std::filesystem::create_directories(file.parent_path());
  const NoForeignCode guard;  // the text of a result may be anybody's
  save_summary(summarise(spec.system, parse_archived_scene(result.scene_text, result.name), result, rules),
               published_summary(spec), rules);
  const std::size_t of_replicate = spec.seed ? 5 : 1, of_bed = 5 * of_replicate, of_drop = 20 * of_replicate;
  RunResult thinned = result;
  for_each_column(thinned.bed, [&](std::vector<double>& column) { thin(column, of_bed); });
  for (std::size_t d = whole ? 1 : 0; d < thinned.drops.size(); ++d)
    for_each_column(thinned.drops[d], [&](std::vector<double>& column) { thin(column, of_drop); });
  if (!whole) thinned.snapshots.clear();
  save_result(thinned, file);
}

}  // namespace slfb
