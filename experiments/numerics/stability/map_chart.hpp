#pragma once

#include "experiments/figures/figure.hpp"
#include "experiments/numerics/stability/map.hpp"

namespace slfb::stability {

/// Draws stability-ID: boundaries with their brackets, theory dashed, settings in use as stars. Where no boundary lies
/// in the range an arrow points out of it. Boundaries of `beside`, this machine's quick set, are open circles.
FigureOutput draw_map(const Map& map, const SolvedMap& solved, const SolvedMap& beside,
                      const std::filesystem::path& folder);

}  // namespace slfb::stability
