// What the tests of the liquid share: an exchange without spheres, volumes of cells and nodes, norms of errors.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/fluid/staggered_liquid.hpp"

namespace slfb {

using Point = std::array<double, 3>;
using Field = std::function<double(const Point&)>;

/// The liquid of a scene whose tier solves for it.
inline std::unique_ptr<fluid::StaggeredLiquid> solved_liquid(const Scene& scene) {
  auto liquid = fluid::make_liquid(scene);
  auto* solved = dynamic_cast<fluid::StaggeredLiquid*>(liquid.get());
  if (solved != nullptr) static_cast<void>(liquid.release());
  return std::unique_ptr<fluid::StaggeredLiquid>(solved);
}

inline fluid::Exchange no_exchange(const fluid::StaggeredLiquid& liquid) {
  fluid::Exchange exchange;
  for (std::size_t a = 0; a < 3; ++a) {
    exchange.coefficient[a].assign(liquid.nodes(a), 0.0);
    exchange.source[a].assign(liquid.nodes(a), 0.0);
  }
  return exchange;
}

inline std::vector<double> cell_volumes(const fluid::ColumnGrid& grid) {
  std::vector<double> volumes(grid.size());
  for (std::size_t c = 0; c < volumes.size(); ++c)
    volumes[c] = grid.volume(static_cast<int>(c / static_cast<std::size_t>(grid.layers())));
  return volumes;
}

/// Volumes of the momentum nodes of a component; 0 where the velocity is given [m³].
inline std::vector<double> node_volumes(const fluid::StaggeredLiquid& liquid, std::size_t a) {
  std::vector<double> volumes;
  liquid.scatter(a, cell_volumes(liquid.grid()), volumes);
  return volumes;
}

inline Point cell_position(const fluid::ColumnGrid& grid, std::size_t cell) {
  const auto layers = static_cast<std::size_t>(grid.layers());
  const auto centre = grid.centre(static_cast<int>(cell / layers));
  return {centre[0], centre[1], (static_cast<double>(cell % layers) + 0.5) * grid.cell_height()};
}

/// Liquid volume per cell of a void fraction α(x) [m³].
inline std::vector<double> liquid_volumes(const fluid::ColumnGrid& grid, const Field& void_fraction) {
  auto volumes = cell_volumes(grid);
  for (std::size_t c = 0; c < volumes.size(); ++c) volumes[c] *= void_fraction(cell_position(grid, c));
  return volumes;
}

/// Starts the liquid from exact fields.
inline void start_from(fluid::StaggeredLiquid& liquid, const std::array<Field, 3>& velocity, const Field& pressure) {
  auto state = liquid.state();
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t n = 0; n < liquid.nodes(a); ++n)
      state.at(std::string("velocity_") + "xyz"[a])[n] = velocity[a](liquid.position(a, n));
  for (std::size_t c = 0; c < liquid.grid().size(); ++c)
    state.at("pressure")[c] = pressure(cell_position(liquid.grid(), c));
  liquid.restore(state);
}

/// Volume means of |error| and of error², the latter under the root.
struct Norms {
  double l1 = 0.0, l2 = 0.0;
};

/// Error of node values against an exact field, within a radius.
inline Norms error_of(const fluid::StaggeredLiquid& liquid, std::size_t a, const std::vector<double>& values,
                      const Field& exact, double radius = 1e300) {
  const auto volume = node_volumes(liquid, a);
  Norms norms;
  double total = 0.0;
  for (std::size_t n = 0; n < volume.size(); ++n) {
    const Point at = liquid.position(a, n);
    if (volume[n] == 0.0 || std::hypot(at[0], at[1]) > radius) continue;
    const double error = values[n] - exact(at);
    norms.l1 += volume[n] * std::abs(error);
    norms.l2 += volume[n] * error * error;
    total += volume[n];
  }
  return {norms.l1 / total, std::sqrt(norms.l2 / total)};
}

/// Order at which an error falls when the cells (or steps) shrink from 1/coarse to 1/fine.
inline double order(double coarse_error, double fine_error, double coarse, double fine) {
  return std::log(coarse_error / fine_error) / std::log(fine / coarse);
}

}  // namespace slfb
