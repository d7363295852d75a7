#include "experiments/numerics/figures.hpp"

#include <utility>

namespace slfb {

std::vector<Figure> numerics_figures() {
  std::vector<Figure> all{pressure_noise(), kinetic_theory(), frontier_integrators(), default_knees(),
                          less_is_enough()};
  for (auto* list : {frontier_charts, stability_maps})
    for (Figure& figure : list()) all.push_back(std::move(figure));
  return all;
}

}  // namespace slfb
