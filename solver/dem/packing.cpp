#include "solver/dem/packing.hpp"

#include <Random123/philox.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "solver/scene/scene_problems.hpp"

namespace slfb::dem {
namespace {

/// Uniform number in [0, 1) from (seed, item, component), the same on every machine.
double uniform(std::uint64_t seed, std::uint64_t item, std::uint64_t component) {
  const r123::Philox4x64::ctr_type counter{{item, component, 0, 0}};
  const r123::Philox4x64::key_type key{{seed, 0}};
  return static_cast<double>(r123::Philox4x64()(counter, key)[0] >> 11) * 0x1.0p-53;
}

}  // namespace

std::vector<PlacedSphere> loose_packing(const Scene& scene) {
  std::vector<int> order;
  double diameter = 0.0;
  for (std::size_t s = 0; s < scene.species.size(); ++s) {
    if (scene.species[s].count == 0) continue;
    order.insert(order.end(), static_cast<std::size_t>(scene.species[s].count), static_cast<int>(s));
    diameter = std::max(diameter, scene.species[s].diameter);
  }
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(uniform(scene.seed, i, 3) * static_cast<double>(i))]);

  const Geometry& geometry = scene.geometry;
  const bool cylinder = geometry.shape == Shape::cylinder;
  const double half_x = 0.5 * (cylinder ? geometry.diameter : geometry.width[0]);
  const double half_y = 0.5 * (cylinder ? geometry.diameter : geometry.width[1]);
  const double jitter = 0.06 * diameter, spacing = diameter + 2.0 * jitter, margin = 0.5 * diameter + jitter;
  const auto sites = [&](double half) {
    return std::max(1, static_cast<int>(std::floor((2.0 * half - 2.0 * margin) / spacing)) + 1);
  };
  const int sites_x = sites(half_x), sites_y = sites(half_y);
  std::vector<PlacedSphere> spheres;
  spheres.reserve(order.size());
  std::uint64_t site = 0;
  for (int layer = 0; spheres.size() < order.size(); ++layer) {
    const double z = margin + layer * spacing;
    if (z + margin > geometry.height)
      throw SceneError(
          fmt::format("species.count: {} spheres do not fit loosely into the column of height {} m ({} did)",
                      order.size(), geometry.height, spheres.size()));
    for (int iy = 0; iy < sites_y; ++iy)
      for (int ix = 0; ix < sites_x && spheres.size() < order.size(); ++ix) {
        const double x = (ix - 0.5 * (sites_x - 1)) * spacing, y = (iy - 0.5 * (sites_y - 1)) * spacing;
        ++site;
        if (cylinder && std::hypot(x, y) + margin > half_x) continue;
        const auto shift = [&](std::uint64_t component) {
          return jitter * (2.0 * uniform(scene.seed, site, component) - 1.0) / std::sqrt(3.0);
        };
        spheres.push_back({{x + shift(0), y + shift(1), z + shift(2)}, order[spheres.size()]});
      }
  }
  return spheres;
}

}  // namespace slfb::dem
