#include "solver/coupling/lone_spheres.hpp"

#include <algorithm>
#include <cmath>

namespace slfb::coupling {
namespace {

constexpr double neighbours_from = 0.1;           ///< s_c
constexpr double largest_own_fraction = 0.005;    ///< of a layer
constexpr double narrowest = 2.0, widest = 10.0;  ///< b in diameters

/// ∫ of the hat of half width 1 from −∞ to x.
double hat_below(double x) {
  const double t = std::clamp(x, -1.0, 1.0);
  return 0.5 + t - 0.5 * t * std::abs(t);
}

double weight_at(double solid_of_others) {
  const double x = std::clamp(solid_of_others / neighbours_from, 0.0, 1.0);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

}  // namespace

void LoneSpheres::update(const std::vector<double>& heights, const std::vector<double>& radii,
                         const VolumeShares& shares, const std::vector<double>& sphere_volume,
                         const std::vector<double>& solid) {
  lone_.clear();
  number_.clear();
  hat_.clear();
  if (!spread_) return;
  const int layers = grid_.layers();
  const double height = grid_.cell_height(), layer_volume = grid_.section_area() * height;
  const auto stride = static_cast<std::size_t>(layers);
  layer_solid_.assign(stride, 0.0);
  for (std::size_t c = 0; c < solid.size(); ++c) layer_solid_[c % stride] += solid[c];
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double diameter = 2.0 * radii[i], volume = sphere_volume[i];
    const double half = std::max(height, std::clamp(volume / (largest_own_fraction * grid_.section_area()),
                                                    narrowest * diameter, widest * diameter));
    const double z = heights[i];
    const int first = std::clamp(static_cast<int>((z - half) / height), 0, layers - 1);
    const int last = std::clamp(static_cast<int>((z + half) / height), 0, layers - 1);
    // What lies beyond an end of the column is left to the layers within.
    const double below = hat_below((first * height - z) / half);
    const double all = hat_below(((last + 1) * height - z) / half) - below;
    if (!(all > 0.0)) continue;
    const std::size_t start = hat_.size();
    double in_hat = 0.0, lower = below;
    for (int k = first; k <= last; ++k) {
      const double upper = hat_below(((k + 1) * height - z) / half);
      hat_.push_back((upper - lower) / all);
      lower = upper;
      in_hat += hat_.back() * layer_solid_[static_cast<std::size_t>(k)] / layer_volume;
    }
    double own_in_hat = 0.0, in_cells = 0.0, own_in_cells = 0.0;
    for (int m = 0; m < shares.count(i); ++m) {
      const std::size_t c = shares.cells(i)[m];
      const double share = shares.shares(i)[m], cell = grid_.volume(static_cast<int>(c / stride));
      const int k = static_cast<int>(c % stride) - first;
      if (k >= 0 && k <= last - first) own_in_hat += share * hat_[start + static_cast<std::size_t>(k)] / layer_volume;
      in_cells += share * solid[c] / cell;
      own_in_cells += share * share / cell;
    }
    const double others = std::max(in_hat - volume * own_in_hat, in_cells - volume * own_in_cells);
    const double weight = weight_at(others);
    if (weight == 0.0) {
      hat_.resize(start);
      continue;
    }
    if (number_.empty()) number_.assign(heights.size(), -1);
    number_[i] = static_cast<int>(lone_.size());
    lone_.push_back({i, weight, weight * volume * own_in_hat, static_cast<std::size_t>(first),
                     static_cast<std::size_t>(last - first + 1), start});
  }
}

void LoneSpheres::spread(const std::vector<double>& values, const VolumeShares& shares,
                         std::vector<double>& cells) const {
  if (!any()) return;
  const auto layers = static_cast<std::size_t>(grid_.layers());
  std::vector<double> per_area(layers, 0.0);
  for (const Lone& sphere : lone_) {
    const double moved = sphere.weight * values[sphere.sphere];
    for (int m = 0; m < shares.count(sphere.sphere); ++m)
      cells[shares.cells(sphere.sphere)[m]] -= moved * shares.shares(sphere.sphere)[m];
    for (std::size_t k = 0; k < sphere.count; ++k)
      per_area[sphere.first + k] += moved * hat_[sphere.start + k] / grid_.section_area();
  }
  for (int s = 0; s < grid_.cells(); ++s)
    for (std::size_t k = 0; k < layers; ++k)
      if (per_area[k] != 0.0) cells[static_cast<std::size_t>(s) * layers + k] += per_area[k] * grid_.area(s);
}

}  // namespace slfb::coupling
