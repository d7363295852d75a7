#include "experiments/run_files.hpp"

#include <fmt/format.h>

namespace slfb {

Scene load_run_scene(const RunSpec& spec) {
  return load_scene(std::filesystem::path(SLFB_SOURCE_DIR) / "experiments" / "scenes" / spec.scene, spec.overrides);
}

std::filesystem::path run_directory(const std::filesystem::path& out, const std::string& hash) {
  return out / "runs" / hash;
}

std::filesystem::path result_file(const std::filesystem::path& out, const std::string& hash) {
  return run_directory(out, hash) / "result.h5";
}

std::filesystem::path published_file(const RunSpec& spec) {
  const std::string variant = spec.variant.empty() ? "default" : spec.variant;
  return std::filesystem::path(SLFB_SOURCE_DIR) / "reports" / "published" / "runs" /
         fmt::format("{}_{:.2f}_{}.h5", spec.system, spec.superficial_velocity, variant);
}

}  // namespace slfb
