#include "solver/run/plugs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace slfb::simulation {

Plugs find_plugs(const std::vector<double>& voidage) {
  Plugs plugs;
  double all = 0.0;
  for (const double e : voidage) all += 1.0 - e;
  std::size_t layers = 0;
  for (double below = 0.0; layers < voidage.size() && below < 0.95 * all; ++layers) below += 1.0 - voidage[layers];
  if (layers == 0) return plugs;
  const auto end = voidage.begin() + static_cast<std::ptrdiff_t>(layers);
  plugs.least = *std::min_element(voidage.begin(), end);
  plugs.largest = *std::max_element(voidage.begin(), end);
  const double mean = static_cast<double>(layers) - std::accumulate(voidage.begin(), end, 0.0);
  const double solids = mean / static_cast<double>(layers);
  bool apart = true;
  for (std::size_t k = 0; k < layers; ++k) {
    const double here = 1.0 - voidage[k];
    if (here < 0.5 * solids) apart = true;
    if (here > solids && std::exchange(apart, false)) ++plugs.count;
  }
  return plugs;
}

Plugs find_plugs(const Model& model) {
  Plugs plugs = find_plugs(model.coupling().void_fraction());
  const dem::VectorField& v = model.particles().velocity;
  double squared = 0.0;
  for (std::size_t i = 0; i < v.x.size(); ++i) squared += v.x[i] * v.x[i] + v.y[i] * v.y[i] + v.z[i] * v.z[i];
  if (!v.x.empty()) plugs.speed = std::sqrt(squared / static_cast<double>(v.x.size()));
  return plugs;
}

std::string describe(const Plugs& plugs, double superficial_velocity) {
  const bool still = plugs.speed < 1e-3 * superficial_velocity;
  if (plugs.count < 3) return "";
  return fmt::format(
      "the bed has come apart into {} plugs (voidage of its layers {:.2f} to {:.2f}){}: in a one-dimensional liquid "
      "nothing moves sideways that would break them up{}; the three-dimensional tier has that motion",
      plugs.count, plugs.least, plugs.largest,
      still ? fmt::format(", which stand still (spheres move at {:.1g} m/s)", plugs.speed) : "",
      still
          ? ", and layers hold a plug whose spheres read means of layers: coupling.interpolation = \"trilinear\" or a "
            "coupling.smoothing_length of 2 diameters lets them go"
          : "");
}

}  // namespace slfb::simulation
