#pragma once

#include <array>

namespace slfb::coupling {

/// Volume of the part of the unit ball with x > a, y > b, z > c; exact for any signs [-].
///
/// For a, b, c ≥ 0 the divergence theorem turns the volume into (S − a A_x − b A_y − c A_z)/3, with S the spherical
/// patch (Gauss-Bonnet: sum of its angles minus π minus the turning of its three small circles) and A_x, A_y, A_z
/// the plane sections. Other signs follow by reflection.
double unit_ball_octant(double a, double b, double c);

/// Volume shared by a sphere and an axis-aligned box [m³].
double sphere_box_overlap(const std::array<double, 3>& centre, double radius, const std::array<double, 3>& lower,
                          const std::array<double, 3>& upper);

}  // namespace slfb::coupling
