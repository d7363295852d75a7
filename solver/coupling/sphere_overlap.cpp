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

/// x > a, y > b, z > c.
double octant(double a, double b, double c, double wedge_ab, double wedge_bc, double wedge_ca, double cap_a,
              double cap_b, double cap_c) {
  if (a * a + b * b + c * c < 1.0)
    return 0.5 * (wedge_ab + wedge_bc + wedge_ca) - 0.25 * (cap_a + cap_b + cap_c) + 0.125 - inverse_ball * a * b * c;
  // The corner lies outside, where the octant of the signs (+, +, +) is empty. What lies beyond a plane and its mirror
  // image fills the wedge of the other two planes, which gives the octants of other signs one reflection at a time.
  double volume = 0.0;
  if (a < 0.0) {
    volume = b < 0.0 ? cap_c - wedge_bc : wedge_bc;                  // y > |b|, z > c
    if (c < 0.0) volume = (b < 0.0 ? 1.0 - cap_b : cap_b) - volume;  // y > |b|, z > |c|
  }
  if (b < 0.0) volume = (c < 0.0 ? cap_a - wedge_ca : wedge_ca) - volume;  // x > a, z > |c|
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
        at(i, j, k) = octant(x[i - 1], y[j - 1], z[k - 1], at(i, j, 0), at(0, j, k), at(i, 0, k), at(i, 0, 0),
                             at(0, j, 0), at(0, 0, k));
  // Then the differences along each axis.
  const int row = z.count + 1, plane = (y.count + 1) * row, all = (x.count + 1) * plane;
  for (int n = 0; n < all - plane; ++n) parts[n] -= parts[n + plane];
  for (int i = 0; i <= x.count; ++i)
    for (int n = 0; n < plane - row; ++n) parts[i * plane + n] -= parts[i * plane + n + row];
  for (int n = 0; n < all; n += row)
    for (int k = 0; k < z.count; ++k) parts[n + k] -= parts[n + k + 1];
}

}  // namespace slfb::coupling
