#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/laws/scene_drag_law.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

/// Voidage of the jump of the law of Gidaspow (1994), between Ergun and Wen & Yu [-].
constexpr double jump = 0.8;

TrialResult solve(const Scene& scene, const Parameters&, int) {
  const Species& sphere = scene.species.front();
  const double start = thread_cpu_seconds();
  constexpr double packed_voidage = 0.4;
  const auto [voidage, regime] = fluidisation::bed_voidage(scene_drag_law(scene), {sphere.diameter, sphere.density},
                                                           {scene.liquid.density, scene.liquid.viscosity},
                                                           scene.liquid.superficial_velocity, packed_voidage);
  TrialResult result;
  using enum fluidisation::BedRegime;
  result.values["voidage"].value = voidage;
  result.values["side_of_jump"].value = regime == at_jump ? 0.0 : voidage < jump ? -1.0 : 1.0;
  result.values["regime"].value = regime == packed ? 0.0 : regime == washed_out ? 2.0 : 1.0;
  result.counts["roots"] = 1.0;
  result.cpu_seconds = thread_cpu_seconds() - start;
  return result;
}

}  // namespace

Problem homogeneous_bed_problem() {
  return {"homogeneous-bed",
          "The bed in which the drag on evenly spread spheres carries their weight, by root finding.",
          "answer",
          "numerics/studies/scenes/box.toml",
          {{"voidage", "voidage", "-"},
           {"side_of_jump", "-1 below, 0 at, 1 above the jump of the drag law", "-"},
           {"regime", "0 packed, 1 fluidised, 2 washed out", "-"}},
          {},
          solve};
}

}  // namespace slfb::studies
