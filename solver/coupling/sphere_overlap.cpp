#include "solver/coupling/sphere_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slfb::coupling {
namespace {

constexpr double ball = 4.0 / 3.0 * std::numbers::pi;

/// x > a.
double cap(double a) {
  if (a >= 1.0) return 0.0;
  if (a <= -1.0) return ball;
  return std::numbers::pi / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a);
}

/// Plane section at distance `offset`: half its corner area and the angle its arc spans.
struct Section {
  double area, angle;
};
Section corner(double offset, double b, double c) {
  const double radius_squared = 1.0 - offset * offset;
  const double along_b = std::sqrt(std::max(0.0, radius_squared - b * b));
  const double along_c = std::sqrt(std::max(0.0, radius_squared - c * c));
  const double angle = std::atan2(along_b, b) - std::atan2(c, along_c);
  return {0.5 * (radius_squared * angle - b * (along_b - c) - c * (along_c - b)), angle};
}

/// Interior angle of the spherical patch where the circles x = a and y = b cross.
double patch_angle(double a, double b) {
  return std::acos(std::clamp(a * b / std::sqrt((1.0 - a * a) * (1.0 - b * b)), -1.0, 1.0));
}

/// a, b, c ≥ 0.
double positive_octant(double a, double b, double c) {
  if (a * a + b * b + c * c >= 1.0) return 0.0;
  const Section x = corner(a, b, c), y = corner(b, c, a), z = corner(c, a, b);
  const double surface = patch_angle(a, b) + patch_angle(b, c) + patch_angle(c, a) - std::numbers::pi - a * x.angle -
                         b * y.angle - c * z.angle;
  return std::max(0.0, (surface - a * x.area - b * y.area - c * z.area) / 3.0);
}

/// x > a, y > b with a, b ≥ 0.
double positive_wedge(double a, double b) { return 2.0 * positive_octant(a, b, 0.0); }

double wedge(double a, double b) {
  if (a < 0.0) return cap(b) - (b < 0.0 ? cap(-a) - positive_wedge(-a, -b) : positive_wedge(-a, b));
  if (b < 0.0) return cap(a) - positive_wedge(a, -b);
  return positive_wedge(a, b);
}

}  // namespace

double unit_ball_octant(double a, double b, double c) {
  a = std::clamp(a, -1.0, 1.0);
  b = std::clamp(b, -1.0, 1.0);
  c = std::clamp(c, -1.0, 1.0);
  if (a < 0.0) return wedge(b, c) - unit_ball_octant(-a, b, c);
  if (b < 0.0) return wedge(a, c) - unit_ball_octant(a, -b, c);
  if (c < 0.0) return wedge(a, b) - positive_octant(a, b, -c);
  return positive_octant(a, b, c);
}

double sphere_box_overlap(const std::array<double, 3>& centre, double radius, const std::array<double, 3>& lower,
                          const std::array<double, 3>& upper) {
  std::array<std::array<double, 2>, 3> plane{};
  for (std::size_t a = 0; a < 3; ++a) {
    plane[a] = {std::clamp((lower[a] - centre[a]) / radius, -1.0, 1.0),
                std::clamp((upper[a] - centre[a]) / radius, -1.0, 1.0)};
    if (plane[a][0] >= plane[a][1]) return 0.0;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t k = 0; k < 2; ++k)
        sum += ((i + j + k) % 2 == 0 ? 1.0 : -1.0) * unit_ball_octant(plane[0][i], plane[1][j], plane[2][k]);
  return std::max(0.0, sum) * radius * radius * radius;
}

}  // namespace slfb::coupling
