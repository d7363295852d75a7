#include "experiments/drag_law_question/drag_law_question.hpp"
#include "experiments/fig01_void_fraction_schemes/fig01.hpp"
#include "experiments/fig05_pressure_drop/fig05.hpp"
#include "experiments/fig08_history/fig08.hpp"
#include "experiments/fig09_trajectories/fig09.hpp"
#include "experiments/fig10_classification_velocity/fig10.hpp"
#include "experiments/fig13_void_fraction/fig13.hpp"
#include "experiments/fig25_collision_force/fig25.hpp"
#include "experiments/figure.hpp"
#include "experiments/frontier/frontier_figures.hpp"
#include "experiments/frontier/integrators.hpp"
#include "experiments/kinetic_theory/kinetic_theory.hpp"
#include "experiments/pressure_noise/pressure_noise.hpp"

namespace slfb {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = [] {
    std::vector<Figure> all{fig01(),
                            fig05(),
                            fig08(),
                            fig09(),
                            fig10(),
                            fig13(),
                            fig25(),
                            drag_law_question(),
                            pressure_noise(),
                            kinetic_theory(),
                            frontier_integrators()};
    for (Figure& figure : study_figures()) all.push_back(std::move(figure));
    return all;
  }();
  return list;
}

}  // namespace slfb
