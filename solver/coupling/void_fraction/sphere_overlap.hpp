#pragma once

#include <array>

#include "solver/support/vec3.hpp"

namespace slfb::coupling {

/// Evenly spaced planes normal to one axis, their distances from the centre of the unit ball in rising order [-].
struct PlaneRow {
  double first = 0.0, spacing = 0.0;
  int count = 0;
  double operator[](int k) const { return first + k * spacing; }
};

/// Cuts the unit ball by three rows of planes into boxes and writes the fraction of its volume in each, z fastest:
/// (x.count + 1)(y.count + 1)(z.count + 1) values that add up to 1 [-]; exact but for round-off.
///
/// The volume beyond one plane of each row is a cap, a wedge or an octant of the ball; boxes are their alternating
/// differences. With l = √(1 − a² − b²), half the length of the edge where two planes meet inside the ball,
///
///   cap     x > a                V_a   = π (1 − a)² (2 + a) / 3
///   wedge   x > a, y > b         V_ab  = [2 arg(ab + il) − a (3 − a²) arg(b + il) − b (3 − b²) arg(a + il) + 2abl] / 3
///   octant  x > a, y > b, z > c  V_abc = (V_ab + V_bc + V_ca) / 2 − (V_a + V_b + V_c) / 4 + π/6 − abc
///
/// The wedge is (S − a A_x − b A_y)/3 by the divergence theorem, with A the plane sections and S the spherical patch,
/// which Gauss–Bonnet gives from its angles and the turning of its circles; near a tangency it does not feel an error
/// of the root, since ∂V_ab/∂l at fixed a and b vanishes with l². The octant holds for a corner inside the ball: there
/// the box |x| < a, |y| < b, |z| < c of volume 8abc lies in the ball whole, and inclusion and exclusion of its six
/// sides give what is beyond its corners. Where edge or corner lies outside, reflections reduce the volume to smaller
/// ones.
void unit_ball_parts(const PlaneRow& x, const PlaneRow& y, const PlaneRow& z, double* parts);

/// The same for four balls at once, each cut by at most one plane per axis, at the given distance from its centre; a
/// distance of 1 or more cuts nothing off. Each ball has its eight parts in one lane.
void unit_ball_octants(const std::array<Pack, 3>& planes, std::array<Pack, 8>& parts);

}  // namespace slfb::coupling
