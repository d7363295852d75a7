#include "experiments/causes/causes.hpp"
#include "experiments/drag_law_question/drag_law_question.hpp"
#include "experiments/fig01_void_fraction_schemes/fig01.hpp"
#include "experiments/fig02_mesh/fig02.hpp"
#include "experiments/fig03_rigs/rigs.hpp"
#include "experiments/fig05_pressure_drop/fig05.hpp"
#include "experiments/fig06_snapshots/fig06.hpp"
#include "experiments/fig07_heights/fig07.hpp"
#include "experiments/fig08_history/fig08.hpp"
#include "experiments/fig09_trajectories/fig09.hpp"
#include "experiments/fig10_classification_velocity/fig10.hpp"
#include "experiments/fig11_velocity_parity/fig11.hpp"
#include "experiments/fig12_liquid_fluctuation/fig12.hpp"
#include "experiments/fig13_void_fraction/fig13.hpp"
#include "experiments/fig14_vorticity/fig14.hpp"
#include "experiments/fig15_paths/fig15.hpp"
#include "experiments/fig16_contacts/fig16.hpp"
#include "experiments/fig17_collisions/fig17.hpp"
#include "experiments/fig18_fluctuating_energy/fig18.hpp"
#include "experiments/fig19_dimensionless_frequency/fig19.hpp"
#include "experiments/fig20_collision_frequency/fig20.hpp"
#include "experiments/fig21_force_history/fig21.hpp"
#include "experiments/fig22_fluid_forces/fig22.hpp"
#include "experiments/fig23_collision_to_drag/fig23.hpp"
#include "experiments/fig24_force_and_voidage/fig24.hpp"
#include "experiments/fig25_collision_force/fig25.hpp"
#include "experiments/fig26_force_parity/fig26.hpp"
#include "experiments/figure.hpp"
#include "experiments/frontier/frontier_figures.hpp"
#include "experiments/frontier/integrators.hpp"
#include "experiments/kinetic_theory/kinetic_theory.hpp"
#include "experiments/pressure_noise/pressure_noise.hpp"
#include "experiments/printed_voidage/printed_voidage.hpp"
#include "experiments/table1_conditions/table1.hpp"
#include "experiments/table2_fitted_lines/table2.hpp"

namespace slfb {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = [] {
    std::vector<Figure> all{table1(),
                            table2(),
                            fig01(),
                            fig02(),
                            fig03(),
                            fig04(),
                            fig05(),
                            fig06(),
                            fig07(),
                            fig08(),
                            fig09(),
                            fig10(),
                            fig11(),
                            fig12(),
                            fig13(),
                            fig14(),
                            fig15(),
                            fig16(),
                            fig17(),
                            fig18(),
                            fig19(),
                            fig20(),
                            fig21(),
                            fig22(),
                            fig23(),
                            fig24(),
                            fig25(),
                            fig26(),
                            drag_law_question(),
                            printed_voidage(),
                            causes(),
                            pressure_noise(),
                            kinetic_theory(),
                            frontier_integrators()};
    for (Figure& figure : study_figures()) all.push_back(std::move(figure));
    return all;
  }();
  return list;
}

}  // namespace slfb
