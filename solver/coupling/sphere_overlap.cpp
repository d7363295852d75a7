#include "solver/coupling/sphere_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace slfb::coupling {
namespace {

// Volumes are fractions of the ball.
constexpr double inverse_ball = 3.0 / (4.0 * std::numbers::pi);

/// x > a.
double cap(double a) {
  a = std::clamp(a, -1.0, 1.0);
  return 0.25 * (1.0 - a) * (1.0 - a) * (2.0 + a);
}

/// x > a, y > b.
double wedge(double a, double b, double cap_a, double cap_b) {
  const double squared = 1.0 - a * a - b * b;
  if (squared <= 0.0) {  // the planes meet outside the ball
    if (a < 0.0) return b < 0.0 ? cap_a + cap_b - 1.0 : cap_b;
    return b < 0.0 ? cap_a : 0.0;
  }
  const double l = std::sqrt(squared);
  const double volume = 2.0 * std::atan2(l, a * b) - a * (3.0 - a * a) * std::atan2(l, b) -
                        b * (3.0 - b * b) * std::atan2(l, a) + 2.0 * a * b * l;
  return std::max(0.0, inverse_ball / 3.0 * volume);
}

/// x > a, y > b, z > c with a, b, c ≥ 0.
double positive_octant(double a, double b, double c) {
  if (a * a + b * b + c * c >= 1.0) return 0.0;
  const double l_ab = std::sqrt(1.0 - a * a - b * b), l_bc = std::sqrt(1.0 - b * b - c * c),
               l_ca = std::sqrt(1.0 - c * c - a * a);
  const double angles = std::atan2(l_ab, a * b) + std::atan2(l_bc, b * c) + std::atan2(l_ca, c * a) - std::numbers::pi;
  const auto arc = [](double p, double q, double l_p, double l_q) {
    return std::atan2(l_p * l_q - p * q, p * l_q + q * l_p);
  };
  const double turning = a * (3.0 - a * a) * arc(b, c, l_ab, l_ca) + b * (3.0 - b * b) * arc(c, a, l_bc, l_ab) +
                         c * (3.0 - c * c) * arc(a, b, l_ca, l_bc);
  const double volume = angles - 0.5 * turning + a * b * l_ab + b * c * l_bc + c * a * l_ca;
  return std::max(0.0, inverse_ball * (volume / 3.0 - a * b * c));
}

/// Of any signs, from the positive one by reflection: what lies beyond a plane and its mirror image fills the wedge of
/// the other two planes.
double octant(double a, double b, double c, double wedge_ab, double wedge_bc, double wedge_ca, double cap_a,
              double cap_c) {
  double volume = positive_octant(std::abs(a), std::abs(b), std::abs(c));
  if (a < 0.0) {
    double mirrored = b < 0.0 ? cap_c - wedge_bc : wedge_bc;          // |b|, c
    if (c < 0.0) mirrored = (b < 0.0 ? cap(-b) : cap(b)) - mirrored;  // |b|, |c|
    volume = mirrored - volume;
  }
  if (b < 0.0) volume = (c < 0.0 ? cap_a - wedge_ca : wedge_ca) - volume;
  if (c < 0.0) volume = wedge_ab - volume;
  return volume;
}

}  // namespace

void unit_ball_parts(const PlaneRow& x, const PlaneRow& y, const PlaneRow& z, double* parts) {
  // First the volume beyond the planes before box (i, j, k), none before the first box of an axis.
  const auto at = [&](int i, int j, int k) -> double& { return parts[(i * (y.count + 1) + j) * (z.count + 1) + k]; };
  at(0, 0, 0) = 1.0;
  for (int i = 1; i <= x.count; ++i) at(i, 0, 0) = cap(x[i - 1]);
  for (int j = 1; j <= y.count; ++j) at(0, j, 0) = cap(y[j - 1]);
  for (int k = 1; k <= z.count; ++k) at(0, 0, k) = cap(z[k - 1]);
  for (int i = 1; i <= x.count; ++i)
    for (int j = 1; j <= y.count; ++j) at(i, j, 0) = wedge(x[i - 1], y[j - 1], at(i, 0, 0), at(0, j, 0));
  for (int j = 1; j <= y.count; ++j)
    for (int k = 1; k <= z.count; ++k) at(0, j, k) = wedge(y[j - 1], z[k - 1], at(0, j, 0), at(0, 0, k));
  for (int i = 1; i <= x.count; ++i)
    for (int k = 1; k <= z.count; ++k) at(i, 0, k) = wedge(x[i - 1], z[k - 1], at(i, 0, 0), at(0, 0, k));
  for (int i = 1; i <= x.count; ++i)
    for (int j = 1; j <= y.count; ++j)
      for (int k = 1; k <= z.count; ++k)
        at(i, j, k) =
            octant(x[i - 1], y[j - 1], z[k - 1], at(i, j, 0), at(0, j, k), at(i, 0, k), at(i, 0, 0), at(0, 0, k));
  // Then the differences along each axis.
  const int row = z.count + 1, plane = (y.count + 1) * row, all = (x.count + 1) * plane;
  for (int n = 0; n < all - plane; ++n) parts[n] -= parts[n + plane];
  for (int i = 0; i <= x.count; ++i)
    for (int n = 0; n < plane - row; ++n) parts[i * plane + n] -= parts[i * plane + n + row];
  for (int n = 0; n < all; n += row)
    for (int k = 0; k < z.count; ++k) parts[n + k] -= parts[n + k + 1];
}

}  // namespace slfb::coupling
