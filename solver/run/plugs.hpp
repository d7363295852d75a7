#pragma once

#include <string>
#include <vector>

#include "solver/run/model.hpp"

namespace slfb::simulation {

/// How a bed in a one-dimensional liquid has come apart into plugs.
///
/// A liquid of one cell over the section cannot turn over sideways, so that nothing breaks up a layer of spheres that
/// is lifted as a whole: voidage waves grow into plugs with layers of liquid between. That is what a bed does which
/// cannot move sideways. Besides, each sphere reads the mean of the layers that it lies in: the drag on a plug hangs on
/// how it lies to the layers, so that a plug can be held by them and stand still for good. That is the discretisation's
/// doing; voidage between the cells (coupling.interpolation = "trilinear") or shares spread over some diameters
/// (coupling.smoothing_length) let it go.
struct Plugs {
  int count = 0;                      ///< runs of layers denser than the bed's mean, apart by emptier ones
  double least = 0.0, largest = 0.0;  ///< voidage of the layers of the bed [-]
  double speed = 0.0;                 ///< of the spheres, root mean square [m/s]
};

/// Runs of layers with more than the mean solids of the bed between layers with less than half of it. Layers belong to
/// the bed up to where 95 % of the solids lie. \param voidage per layer, from below
Plugs find_plugs(const std::vector<double>& voidage);

/// The same with the speed of the spheres, of a model whose liquid has one cell over the section.
Plugs find_plugs(const Model& model);

/// What a user should know of them; empty if the bed is whole and moves. Standing still means a speed below a
/// thousandth of `superficial_velocity` [m/s].
std::string describe(const Plugs& plugs, double superficial_velocity);

}  // namespace slfb::simulation
