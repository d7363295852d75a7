#include "experiments/figures/sphere_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace slfb {
namespace {

using Colour = std::array<double, 3>;  // red, green, blue from 0 to 1

constexpr Colour glass{0.48, 0.65, 0.79}, steel{0.80, 0.16, 0.12}, background{0.93, 0.95, 0.97}, black{0.0, 0.0, 0.0},
    white{1.0, 1.0, 1.0};

Colour mix(const Colour& from, const Colour& to, double share) {
  Colour result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = from[k] + share * (to[k] - from[k]);
  return result;
}

double code(const Colour& colour) {
  double value = 0.0;
  for (const double part : colour) value = 256.0 * value + std::round(255.0 * part);
  return value;
}

/// Discs of a shaded sphere from the rim to the highlight: radius and shift towards the light over the sphere's radius,
/// and how dark or bright the disc is (below zero towards black, above towards white).
struct Disc {
  double radius, shift, light;
};
constexpr std::array<Disc, 6> discs{{{1.0, 0.0, -0.55},
                                     {0.94, 0.03, -0.28},
                                     {0.82, 0.09, -0.10},
                                     {0.64, 0.17, 0.08},
                                     {0.42, 0.26, 0.30},
                                     {0.18, 0.36, 0.75}}};

/// Which part of the picture is covered already, in points of a quarter of a millimetre.
class Cover {
 public:
  explicit Cover(const SphereView& view)
      : view_(view),
        columns_(static_cast<int>(std::ceil((view.upper_x - view.lower_x) / point))),
        rows_(static_cast<int>(std::ceil((view.upper_z - view.lower_z) / point))),
        covered_(static_cast<std::size_t>(std::max(0, columns_ * rows_)), false) {}

  /// Covers a disc; true when some of it was still open, more than a speck.
  bool add(double x, double z, double radius) {
    int seen = 0;
    const auto index = [](double distance) { return static_cast<int>(std::floor(distance / point)); };
    for (int row = std::max(0, index(z - radius - view_.lower_z));
         row <= std::min(rows_ - 1, index(z + radius - view_.lower_z)); ++row)
      for (int column = std::max(0, index(x - radius - view_.lower_x));
           column <= std::min(columns_ - 1, index(x + radius - view_.lower_x)); ++column) {
        const double dx = view_.lower_x + (column + 0.5) * point - x, dz = view_.lower_z + (row + 0.5) * point - z;
        const auto place = static_cast<std::size_t>(row * columns_ + column);
        if (dx * dx + dz * dz > radius * radius || covered_[place]) continue;
        covered_[place] = true;
        ++seen;
      }
    return seen > 3;
  }

 private:
  static constexpr double point = 2.5e-4;
  const SphereView& view_;
  int columns_, rows_;
  std::vector<bool> covered_;
};

}  // namespace

DataTable sphere_picture(const Snapshot& snapshot, const SphereView& view, const std::string& name) {
  std::vector<std::size_t> shown(snapshot.x.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  const auto is_foreign = [&](std::size_t i) { return static_cast<std::int64_t>(i) == snapshot.foreign; };
  std::erase_if(shown, [&](std::size_t i) {
    const double r = snapshot.radius[i];
    const bool outside = snapshot.x[i] + r < view.lower_x || snapshot.x[i] - r > view.upper_x ||
                         snapshot.z[i] + r < view.lower_z || snapshot.z[i] - r > view.upper_z;
    return outside || (snapshot.y[i] < view.clip_y && !is_foreign(i));
  });
  // From the eye backwards, to leave out what is hidden.
  std::sort(shown.begin(), shown.end(), [&](std::size_t a, std::size_t b) { return snapshot.y[a] < snapshot.y[b]; });
  Cover cover(view);
  std::erase_if(shown, [&](std::size_t i) { return !cover.add(snapshot.x[i], snapshot.z[i], snapshot.radius[i]); });
  std::reverse(shown.begin(), shown.end());

  DataTable table{name, {"x [m]", "z [m]", "radius [m]", "colour [-]"}, {}};
  for (const std::size_t i : shown) {
    const double distance = std::clamp((snapshot.y[i] - view.clip_y) / view.depth, 0.0, 1.0);
    const double r = snapshot.radius[i];
    for (const Disc& disc : discs) {
      const Colour own = is_foreign(i) ? steel : glass;
      const Colour lit = disc.light < 0.0 ? mix(own, black, -disc.light) : mix(own, white, disc.light);
      const Colour seen = is_foreign(i) ? lit : mix(lit, background, 0.75 * distance);
      // The light comes from the upper left.
      table.rows.push_back(
          {snapshot.x[i] - 0.7 * disc.shift * r, snapshot.z[i] + 0.7 * disc.shift * r, disc.radius * r, code(seen)});
    }
  }
  return table;
}

}  // namespace slfb
