#pragma once

#include <string>

#include "reports/gnuplot.hpp"
#include "solver/io/run_result.hpp"

/// Rendered pictures of the spheres of a snapshot, drawn as discs from back to front.
namespace slfb {

/// What a picture shows; seen along y from the side of negative y.
struct SphereView {
  double lower_x = 0.0, upper_x = 0.0;  ///< [m]
  double lower_z = 0.0, upper_z = 0.0;  ///< [m]
  double clip_y = 0.0;                  ///< spheres with their centre nearer to the eye are left out [m]
  double depth = 0.025;                 ///< distance behind the clipping plane at which spheres are palest [m]
};

/// Discs of the visible spheres, farthest first, several per sphere for its shading. Columns: x, z, radius, colour
/// (0xRRGGBB). The dropped sphere is red and never clipped. A plot draws them with `@spheres` (reports/style.gp).
DataTable sphere_picture(const Snapshot& snapshot, const SphereView& view, const std::string& name);

}  // namespace slfb
