#include "solver/coupling/void_fraction/sphere_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#if defined(__AVX2__) && defined(__GLIBC__)
/// Of glibc's vector library: atan2 of four pairs, to 4 units in the last place.
/// The name is the one that the vector ABI gives it.
extern "C" slfb::Pack _ZGVdN4vv_atan2(slfb::Pack y, slfb::Pack x);  // NOLINT(bugprone-reserved-identifier)
#endif

namespace slfb::coupling {
namespace {

// Volumes are fractions of the ball. Number: double, or Pack for four balls at once.
constexpr double inverse_ball = 3.0 / (4.0 * std::numbers::pi);

double root(double x) { return std::sqrt(x); }
Pack root(Pack x) {
  for (int lane = 0; lane < 4; ++lane) x[lane] = std::sqrt(x[lane]);
  return x;
}

double arctangent(double y, double x) { return std::atan2(y, x); }
Pack arctangent(Pack y, Pack x) {
#if defined(__AVX2__) && defined(__GLIBC__)
  return _ZGVdN4vv_atan2(y, x);
#else
  for (int lane = 0; lane < 4; ++lane) y[lane] = std::atan2(y[lane], x[lane]);
  return y;
#endif
}

/// x > a, for a from -1 to 1.
template <class Number>
Number cap(Number a) {
  return 0.25 * (1.0 - a) * (1.0 - a) * (2.0 + a);
}
double cap_of_plane(double a) { return cap(std::clamp(a, -1.0, 1.0)); }

/// x > a, y > b, where the planes meet inside the ball: squared = 1 - a² - b² > 0.
template <class Number>
Number wedge_inside(Number a, Number b, Number squared) {
  const Number l = root(squared);
  return inverse_ball / 3.0 *
         (2.0 * arctangent(l, a * b) - a * (3.0 - a * a) * arctangent(l, b) - b * (3.0 - b * b) * arctangent(l, a) +
          2.0 * a * b * l);
}

/// x > a, y > b, where they do not.
template <class Number>
Number wedge_outside(Number a, Number b, Number cap_a, Number cap_b) {
  const Number nothing = 0.0 * a;
  return a < 0.0 ? (b < 0.0 ? cap_a + cap_b - 1.0 : cap_b) : (b < 0.0 ? cap_a : nothing);
}

double wedge(double a, double b, double cap_a, double cap_b) {
  const double squared = 1.0 - a * a - b * b;
  return squared > 0.0 ? std::max(0.0, wedge_inside(a, b, squared)) : wedge_outside(a, b, cap_a, cap_b);
}

Pack wedge(Pack a, Pack b, Pack cap_a, Pack cap_b) {
  const Pack squared = 1.0 - a * a - b * b, nothing{};
  const Pack outside = wedge_outside(a, b, cap_a, cap_b);
  const auto meet = squared > 0.0;
  if (!(meet[0] | meet[1] | meet[2] | meet[3])) return outside;
  const Pack inside = wedge_inside(a, b, meet ? squared : nothing);
  return meet ? (inside > 0.0 ? inside : nothing) : outside;
}

/// x > a, y > b, z > c.
template <class Number>
Number octant(Number a, Number b, Number c, Number wedge_ab, Number wedge_bc, Number wedge_ca, Number cap_a,
              Number cap_b, Number cap_c) {
  const Number inside =
      0.5 * (wedge_ab + wedge_bc + wedge_ca) - 0.25 * (cap_a + cap_b + cap_c) + 0.125 - inverse_ball * a * b * c;
  // Where the corner lies outside, the octant of the signs (+, +, +) is empty. What lies beyond a plane and its mirror
  // image fills the wedge of the other two planes, which gives the octants of other signs one reflection at a time.
  const Number nothing = 0.0 * a;
  const Number beyond_bc = b < 0.0 ? cap_c - wedge_bc : wedge_bc;                             // y > |b|, z > c
  const Number beyond_a = c < 0.0 ? (b < 0.0 ? 1.0 - cap_b : cap_b) - beyond_bc : beyond_bc;  // y > |b|, z > |c|
  const Number a_done = a < 0.0 ? beyond_a : nothing;
  const Number b_done = b < 0.0 ? (c < 0.0 ? cap_a - wedge_ca : wedge_ca) - a_done : a_done;  // x > a, z > |c|
  const Number outside = c < 0.0 ? wedge_ab - b_done : b_done;
  return a * a + b * b + c * c < 1.0 ? inside : outside;
}

}  // namespace

void unit_ball_parts(const PlaneRow& x, const PlaneRow& y, const PlaneRow& z, double* parts) {
  // First the volume beyond the planes before box (i, j, k), none before the first box of an axis.
  const auto at = [&](int i, int j, int k) -> double& { return parts[(i * (y.count + 1) + j) * (z.count + 1) + k]; };
  at(0, 0, 0) = 1.0;
  for (int i = 1; i <= x.count; ++i) at(i, 0, 0) = cap_of_plane(x[i - 1]);
  for (int j = 1; j <= y.count; ++j) at(0, j, 0) = cap_of_plane(y[j - 1]);
  for (int k = 1; k <= z.count; ++k) at(0, 0, k) = cap_of_plane(z[k - 1]);
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

void unit_ball_octants(const std::array<Pack, 3>& planes, std::array<Pack, 8>& parts) {
  std::array<Pack, 3> plane, caps;
  const Pack one = Pack{} + 1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    plane[a] = planes[a] < -1.0 ? -one : planes[a] < 1.0 ? planes[a] : one;
    caps[a] = cap(plane[a]);
  }
  const auto& [a, b, c] = plane;
  const auto& [cap_a, cap_b, cap_c] = caps;
  const Pack wedge_ab = wedge(a, b, cap_a, cap_b), wedge_bc = wedge(b, c, cap_b, cap_c),
             wedge_ca = wedge(c, a, cap_c, cap_a);
  const Pack corner = octant(a, b, c, wedge_ab, wedge_bc, wedge_ca, cap_a, cap_b, cap_c);
  // Beyond the planes named, and within the others.
  const Pack a_only = cap_a - wedge_ab - (wedge_ca - corner), b_only = cap_b - wedge_ab - (wedge_bc - corner),
             c_only = cap_c - wedge_bc - (wedge_ca - corner);
  const Pack ab = wedge_ab - corner, bc = wedge_bc - corner, ca = wedge_ca - corner;
  parts = {1.0 - cap_a - b_only - c_only - bc, c_only, b_only, bc, a_only, ca, ab, corner};
}

}  // namespace slfb::coupling
