#include "experiments/work/measured_systems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"

namespace slfb {
namespace {

/// Of the first run of the system, in the default profile if it is there.
Scene scene_of(const Work& work, const std::string& system) {
  std::vector<std::string> profiles = profile_names(work);
  std::stable_partition(profiles.begin(), profiles.end(),
                        [&](const std::string& name) { return name == work.default_profile; });
  for (const std::string& name : profiles) {
    const Profile profile = load_profile(work, name);
    const auto run = std::ranges::find_if(
        profile.runs, [&](const RunSpec& spec) { return spec.system == system && spec.variant.empty(); });
    if (run != profile.runs.end()) return load_run_scene(*run);
  }
  throw std::runtime_error(fmt::format("{} has no scene of {}: scene = \"FILE\" names one", work.id, system));
}

}  // namespace

MeasuredSystems measured_systems(const Work& work) {
  MeasuredSystems systems{work.measuring, {}, {}};
  for (const System& system : work.systems) systems.names.push_back(system.name);
  systems.scene_of = [&work](const std::string& system) { return scene_of(work, system); };
  return systems;
}

}  // namespace slfb
