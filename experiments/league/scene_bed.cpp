#include "experiments/league/scene_bed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "correlations/drag/ergun_1952.hpp"

namespace slfb::league {
namespace {

const Species& bed_species(const Scene& scene) {
  const Species* found = nullptr;
  for (const Species& species : scene.species) {
    if (species.count == 0) continue;
    if (found != nullptr)
      throw std::invalid_argument("the bed has several kinds of spheres; the measured beds have one");
    found = &species;
  }
  if (found == nullptr) throw std::invalid_argument("the scene has no bed: no species has a count");
  return *found;
}

double tube_diameter(const Scene& scene) {
  const Geometry& geometry = scene.geometry;
  if (geometry.shape == Shape::cylinder) return geometry.diameter;
  if (scene.fluid.wall == LateralBoundary::periodic) return 0.0;
  return 2.0 * geometry.width[0] * geometry.width[1] / (geometry.width[0] + geometry.width[1]);
}

/// `value` ± sigma, without anything beyond Gauss.
Predicted gaussian(double value, double sigma) {
  return {value, {value - sigma, value + sigma}, {value - 2.0 * sigma, value + 2.0 * sigma}};
}

}  // namespace

Bed bed_of(const Scene& scene) {
  const Species& spheres = bed_species(scene);
  const Bed bed{{spheres.diameter, spheres.density},
                {scene.liquid.density, scene.liquid.viscosity},
                tube_diameter(scene),
                BedMotion::fluidised};
  if (!(bed.sphere.density > bed.liquid.density))
    throw std::invalid_argument("the spheres of the bed do not sink in the liquid");
  return bed;
}

ScenePrediction predict_scene(const Scene& scene, const Contender& law, double packed_voidage, double tier_error) {
  const Bed bed = bed_of(scene);
  const Measured& all = measured();
  const double velocity = scene.liquid.superficial_velocity, section = scene.geometry.cross_section();
  const double solids = static_cast<double>(bed_species(scene).count) * bed.sphere.volume();
  const auto ergun = drag::kernels_of<drag::Ergun1952>();

  ScenePrediction result{&law, law.voidage(bed, velocity, packed_voidage).regime, {}, {}, {}, {}};
  result.voidage = predict_voidage(law, bed, velocity, packed_voidage, all.lines, tier_error);
  if (result.regime == fluidisation::BedRegime::packed) result.voidage = gaussian(packed_voidage, packed_voidage_sigma);
  const auto height = [&](double voidage) { return voidage < 1.0 ? solids / (section * (1.0 - voidage)) : HUGE_VAL; };
  const auto heights = [&](std::pair<double, double> range) {
    return std::pair{height(range.first), height(range.second)};
  };
  result.bed_height = {height(result.voidage.value), heights(result.voidage.one_sigma),
                       heights(result.voidage.two_sigma)};
  result.minimum_fluidisation = predict_minimum_fluidisation(ergun, bed, all.packed, packed_voidage);

  const double weight = solids * (bed.sphere.density - bed.liquid.density) * gravitational_acceleration / section;
  if (velocity < result.minimum_fluidisation.value) {
    const Statistic packed = statistic_of(compare_packed(ergun, all.packed), 0.0);
    const double reynolds = reynolds_number(bed.liquid, bed.sphere.diameter, velocity);
    const auto carried = [&](double voidage) {
      return fluidisation::drag_over_buoyant_weight(ergun, voidage, reynolds, bed.archimedes()) * weight;
    };
    const double value = carried(packed_voidage) * std::exp(-packed.mean);
    const double by_voidage =
        0.5 * (carried(packed_voidage - packed_voidage_sigma) - carried(packed_voidage + packed_voidage_sigma));
    result.pressure_drop = gaussian(value, std::hypot(value * packed.total_spread, by_voidage));
  } else if (result.regime == fluidisation::BedRegime::washed_out) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    result.pressure_drop = gaussian(none, none);
  } else {
    result.pressure_drop =
        gaussian(weight, bed.liquid.density * velocity * velocity * (1.0 / result.voidage.value - 1.0));
  }
  return result;
}

std::optional<Recommendation> recommend(const Scene& scene, const std::vector<Contender>& laws,
                                        const std::string& scene_law) {
  std::optional<Bed> bed;
  try {
    bed = bed_of(scene);
  } catch (const std::invalid_argument&) {  // measurements say nothing of it
    return std::nullopt;
  }
  const auto evidence = evidence_for(*bed, laws, measured().lines);
  const auto drag_law = std::ranges::find_if(evidence, [](const Evidence& one) {
    return one.law->kind() == ContenderKind::drag_law && !one.law->with_wall();
  });
  if (drag_law == evidence.end()) return std::nullopt;
  Recommendation found{evidence.front(), *drag_law, {}};
  for (const Evidence& one : evidence)
    if (one.law->name() == scene_law) found.of_the_scene = one;
  return found;
}

}  // namespace slfb::league
