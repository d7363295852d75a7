#include "experiments/numerics/plan/settled_bed.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/materials.hpp"
#include "experiments/quantities/analysis.hpp"
#include "solver/laws/scene_drag_law.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"

namespace slfb::plan {
namespace {

constexpr double most_particle_steps = 1.5e7;  ///< of one bed: a second or two of one core
constexpr double fewest_spheres = 200.0, most_spheres = 800.0;
constexpr int beds = 3;

/// A folder of a run that nobody keeps.
class PassingFolder {
 public:
  PassingFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "slfb-settle-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
    path_ = name;
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  ~PassingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

double spheres_of(const Scene& scene) {
  return std::accumulate(scene.species.begin(), scene.species.end(), 0.0,
                         [](double sum, const Species& species) { return sum + static_cast<double>(species.count); });
}

/// The first stage of the scene with fewer spheres in a column as much lower.
Scene part_of(const Scene& scene) {
  Scene part = scene;
  part.stages.resize(1);
  part.stages.front().duration *= 2.0;  // a packing at rest, also where the scene begins a little sooner
  part.fluid.tier = FluidTier::quiescent;
  part.fluid.time_step = part.contact.time_step;
  part.liquid.superficial_velocity = 0.0;
  part.recording.snapshot_interval = 0.0;
  part.recording.checkpoint_interval = 1e6;
  const double wanted = std::clamp(most_particle_steps * part.contact.time_step / part.stages.front().duration,
                                   fewest_spheres, most_spheres);
  const double share = std::min(1.0, wanted / spheres_of(scene));
  double largest = 0.0;
  for (Species& species : part.species) {
    if (species.count > 0)
      species.count = std::max<std::int64_t>(1, std::llround(share * static_cast<double>(species.count)));
    largest = std::max(largest, species.diameter);
  }
  part.geometry.height = std::max(share * part.geometry.height, 6.0 * largest);
  // Checked again: what a smaller bed cannot have is an error before anything runs.
  return parse_scene(canonical_toml(part), "settling", {"contact.allow_large_time_step=true"});
}

const Species& leading_sphere(const Scene& scene) {
  const auto found = std::ranges::find_if(scene.species, [](const Species& species) { return species.count > 0; });
  return found == scene.species.end() ? scene.species.front() : *found;
}

}  // namespace

SettledBed settle(const Scene& scene) {
  if (!(spheres_of(scene) > 0.0)) throw std::invalid_argument("the scene has no bed that could settle");
  Scene part = part_of(scene);
  std::vector<double> voidages;
  for (int bed = 0; bed < beds; ++bed) {
    const PassingFolder folder;
    voidages.push_back(run_scene(part, {.directory = folder.path()}).result.packed_voidage);
    ++part.seed;
  }
  const ReplicateEstimate estimate = estimate_replicates(voidages);
  return {estimate.mean, estimate.half_width, beds, spheres_of(part)};
}

double minimum_fluidisation_velocity(const Scene& scene, double packed_voidage) {
  const Species& sphere = leading_sphere(scene);
  return fluidisation::minimum_fluidisation_velocity(scene_drag_law(scene), Sphere{sphere.diameter, sphere.density},
                                                     LiquidProperties{scene.liquid.density, scene.liquid.viscosity},
                                                     packed_voidage);
}

}  // namespace slfb::plan
