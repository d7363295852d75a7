#include "experiments/peng_2014/figures.hpp"

#include "experiments/figures/figure.hpp"
#include "experiments/numerics/figures.hpp"

namespace slfb {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = [] {
    std::vector<Figure> all{table1_conditions::figure(),
                            table2_fitted_lines::figure(),
                            fig01_void_fraction_schemes::figure(),
                            fig02_mesh::figure(),
                            fig03_settling_rig::figure(),
                            fig04_velocimetry_rig::figure(),
                            fig05_pressure_drop::figure(),
                            fig06_snapshots::figure(),
                            fig07_heights::figure(),
                            fig08_history::figure(),
                            fig09_trajectories::figure(),
                            fig10_classification_velocity::figure(),
                            fig11_velocity_parity::figure(),
                            fig12_liquid_fluctuation::figure(),
                            fig13_void_fraction::figure(),
                            fig14_vorticity::figure(),
                            fig15_paths::figure(),
                            fig16_contacts::figure(),
                            fig17_collisions::figure(),
                            fig18_fluctuating_energy::figure(),
                            fig19_dimensionless_frequency::figure(),
                            fig20_collision_frequency::figure(),
                            fig21_force_history::figure(),
                            fig22_fluid_forces::figure(),
                            fig23_collision_to_drag::figure(),
                            fig24_force_and_voidage::figure(),
                            fig25_collision_force::figure(),
                            fig26_force_parity::figure(),
                            drag_law_question::figure(),
                            printed_voidage::figure(),
                            measured_neighbours::figure(),
                            causes::figure(),
                            most_likely::figure(),
                            from_66_hours::figure(),
                            paper_steps::figure(),
                            grid_convergence::figure(),
                            planned_figures::figure()};
    for (Figure& figure : numerics_figures()) all.push_back(std::move(figure));
    return all;
  }();
  return list;
}

}  // namespace slfb
