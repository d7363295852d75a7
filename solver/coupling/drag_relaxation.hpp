#pragma once

#include "correlations/drag/drag_law_kernels.hpp"
#include "solver/scene/scene.hpp"

namespace slfb::coupling {

/// Time in which drag alone would stop a creeping sphere of the bed, the shortest of its species, at a packed voidage
/// of 0.4 [s]: from ρ_P dv/dt = -β v / (1 - ε), with β of `drag_law`. Where the liquid step is many times longer, the
/// drag on spheres in contact lags behind them and may feed their motion instead of damping it. Infinite without bed
/// spheres.
double packed_relaxation_time(const Scene& scene, const drag::DragLawKernels& drag_law);

}  // namespace slfb::coupling
