#include "solver/coupling/drag_relaxation.hpp"

#include <algorithm>
#include <limits>

namespace slfb::coupling {

double packed_relaxation_time(const Scene& scene, const drag::DragLawKernels& drag_law) {
  constexpr double packed_voidage = 0.4, creeping = 1e-3;
  const double drag = drag_law({packed_voidage, creeping}) * (scene.coupling.drag_times_voidage ? packed_voidage : 1.0);
  double time = std::numeric_limits<double>::infinity();
  for (const Species& species : scene.species)
    if (species.count > 0)
      time = std::min(time, species.density / drag::exchange_per_solid_volume(drag, packed_voidage, species.diameter,
                                                                              scene.liquid.viscosity));
  return time;
}

}  // namespace slfb::coupling
