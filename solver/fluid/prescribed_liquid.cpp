#include "solver/fluid/prescribed_liquid.hpp"

namespace slfb::fluid {

PrescribedLiquid::PrescribedLiquid(const Scene& scene, double velocity)
    : grid_(ColumnGrid::single_cell(scene)), velocity_(velocity), pressure_(grid_.size(), 0.0) {}

void PrescribedLiquid::gather(std::array<std::vector<double>, 3>& velocity,
                              std::array<std::vector<double>, 3>& stress) const {
  for (auto* fields : {&velocity, &stress})
    for (auto& field : *fields) field.assign(grid_.size(), 0.0);
  velocity[2].assign(grid_.size(), velocity_);
}

void PrescribedLiquid::gather_pressure_gradient(std::size_t, std::vector<double>& cells) const {
  cells.assign(grid_.size(), 0.0);
}

std::unique_ptr<Liquid> make_prescribed_liquid(const Scene& scene, int) {
  return std::make_unique<PrescribedLiquid>(scene, scene.first_superficial_velocity());
}

}  // namespace slfb::fluid
