#pragma once

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
/// differences. By the divergence theorem the volume with x > a, y > b, z > c is (S − a A_x − b A_y − c A_z)/3, with A
/// the plane sections and S the spherical patch, which Gauss–Bonnet gives from its angles and the turning of its
/// circles. With l_ab = √(1 − a² − b²) and φ_ab = arg(ab + i l_ab), the angle where two planes meet the sphere,
///
///   cap     V(a) = π (1 − a)² (2 + a) / 3
///   wedge   V(a, b) = [2 φ_ab − a (3 − a²) arg(b + i l_ab) − b (3 − b²) arg(a + i l_ab) + 2 a b l_ab] / 3
///   octant  V(a, b, c) = [Σ φ_ab − π − ½ Σ a (3 − a²) θ_a + Σ a b l_ab] / 3 − a b c
///
/// sums over the three pairs or planes, θ_a the arc on the plane x = a. Near a tangency the volume does not feel an
/// error of the root, since ∂V/∂l_ab at fixed a and b vanishes with l_ab².
void unit_ball_parts(const PlaneRow& x, const PlaneRow& y, const PlaneRow& z, double* parts);

}  // namespace slfb::coupling
