#include "solver/laws/scene_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correlations/drag/single_sphere/schiller_naumann_1935.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb {
namespace {

void add_rounded_times(const Scene& scene, std::vector<std::string>& remarks) {
  const double step = scene.fluid.time_step;
  const auto look = [&](const std::string& key, double time) {
    const double whole = std::max(1.0, std::round(time / step));
    if (time > 0.0 && std::abs(whole * step - time) > 1e-9 * time)
      remarks.push_back(fmt::format("{} = {:g} s is {:.6g} liquid steps of {:g} s: {:g} s is taken", key, time,
                                    time / step, step, whole * step));
  };
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    look(fmt::format("stage[{}].duration", i), scene.stages[i].duration);
    look(fmt::format("stage[{}].relaxation", i), scene.stages[i].relaxation);
  }
  const auto has = [&](auto of_stage) { return std::ranges::any_of(scene.stages, of_stage); };
  const bool in_liquid = has([](const Stage& stage) { return stage.kind != StageKind::settle; });
  const bool in_bed = std::ranges::any_of(scene.species, [](const Species& species) { return species.count > 0; });
  if (in_liquid && in_bed) look("recording.bed_interval", scene.recording.bed_interval);
  if (has([](const Stage& stage) { return stage.kind == StageKind::drop; }))
    look("recording.drop_interval", scene.recording.drop_interval);
  if (in_liquid) look("recording.snapshot_interval", scene.recording.snapshot_interval);
}

/// Samples that a run is too short for.
void add_missing_samples(const Scene& scene, std::vector<std::string>& remarks) {
  double in_liquid = 0.0, longest_fall = 0.0;
  for (const Stage& stage : scene.stages) {
    if (stage.kind == StageKind::settle) continue;
    in_liquid += stage.duration * (stage.kind == StageKind::drop ? stage.repetitions : 1);
    if (stage.kind == StageKind::drop) longest_fall = std::max(longest_fall, stage.duration);
  }
  const auto look = [&](const char* key, double interval, const char* of, double time) {
    if (time > 0.0 && interval > time)
      remarks.push_back(
          fmt::format("{} = {:g} s is longer than {} of {:g} s: nothing is recorded then", key, interval, of, time));
  };
  if (std::ranges::any_of(scene.species, [](const Species& species) { return species.count > 0; }))
    look("recording.bed_interval", scene.recording.bed_interval, "the stages in the liquid", in_liquid);
  look("recording.drop_interval", scene.recording.drop_interval, "a fall", longest_fall);
  look("recording.snapshot_interval", scene.recording.snapshot_interval, "the stages in the liquid", in_liquid);
}

void add_law_range(const Scene& scene, std::vector<std::string>& remarks) {
  if (is_user_law(scene.coupling.drag_law)) return;
  const LawInfo law = find_drag_law(scene.coupling.drag_law).info;
  const LiquidProperties liquid{scene.liquid.density, scene.liquid.viscosity};
  const auto look = [&](const std::string& whose, double voidage, double reynolds) {
    const auto words = [](const Range& range) { return fmt::format("{:g} to {:g}", range.lower, range.upper); };
    if (!law.voidage.contains(voidage))
      remarks.push_back(fmt::format("the drag law {} is meant for voidages of {}; {} meets {:.3g}", law.name,
                                    words(law.voidage), whose, voidage));
    if (!law.reynolds.contains(reynolds))
      remarks.push_back(fmt::format("the drag law {} is meant for Re of {}; {} has about {:.3g}", law.name,
                                    words(law.reynolds), whose, reynolds));
  };
  constexpr double packed_voidage = 0.4;
  for (const Species& species : scene.species) {
    const Sphere sphere{species.diameter, species.density};
    if (species.count > 0 && scene.liquid.superficial_velocity > 0.0)
      look(fmt::format("the packed bed of {}", species.name), packed_voidage,
           reynolds_number(liquid, species.diameter, scene.liquid.superficial_velocity));
    const bool dropped = std::ranges::any_of(scene.stages, [&](const Stage& stage) {
      return stage.kind == StageKind::drop && stage.species == species.name;
    });
    if (!dropped || species.density == liquid.density) continue;
    // One that is lighter rises as fast as one that is as much heavier falls.
    const double velocity =
        fluidisation::slip_velocity(drag::single_sphere::SchillerNaumann1935{}, species.diameter, liquid,
                                    std::abs(sphere.density - liquid.density) * gravitational_acceleration);
    look(fmt::format("a dropped sphere of {} alone", species.name), 1.0,
         reynolds_number(liquid, species.diameter, velocity));
  }
}

}  // namespace

std::vector<std::string> remarks_on(const Scene& scene) {
  std::vector<std::string> remarks;
  add_rounded_times(scene, remarks);
  add_missing_samples(scene, remarks);
  add_law_range(scene, remarks);
  const bool in_bed = std::ranges::any_of(scene.species, [](const Species& species) { return species.count > 0; });
  if (scene.geometry.inclination > 0.0 && scene.fluid.tier != FluidTier::three_dimensional && in_bed)
    remarks.emplace_back(
        "geometry.inclination: in an inclined column the liquid rises along the upper wall while spheres slide down "
        "the lower one; only tier = \"three-dimensional\" has that circulation");
  return remarks;
}

}  // namespace slfb
