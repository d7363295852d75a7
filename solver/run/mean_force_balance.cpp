#include "solver/run/mean_force_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "correlations/materials.hpp"

namespace slfb::simulation {

using coupling::ForceBalance;

void MeanForceBalance::start_step(const Model& model) { sphere_momentum_ = model.sphere_momentum(); }

void MeanForceBalance::end_step(const Model& model) {
  if (!model.liquid().two_way()) return;
  const double momentum = model.liquid().vertical_momentum();
  const double before = std::exchange(liquid_momentum_, momentum);
  if (!std::exchange(momentum_is_known_, true)) return;
  ForceBalance now;
  const dem::Particles& particles = model.particles();
  const auto contacts = model.engine().mean_vertical_wall_forces();
  const auto& liquid = model.liquid().vertical_forces();
  const double gravity = scene_.geometry.gravity()[2];
  double mass = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    now.force[ForceBalance::buoyant_weight] +=
        gravity * (particles.mass[i] - scene_.liquid.density * particles.volume(i));
    mass += particles.mass[i];
  }
  now.force[ForceBalance::pressure] = liquid.pressure;
  now.force[ForceBalance::bottom] = contacts.bottom;
  now.force[ForceBalance::walls] = contacts.others;
  now.force[ForceBalance::shear] = liquid.stress;
  now.force[ForceBalance::flow] = liquid.inflow - liquid.outflow;
  now.force[ForceBalance::sphere_inertia] = -(model.sphere_momentum() - sphere_momentum_) / scene_.fluid.time_step;
  now.force[ForceBalance::liquid_inertia] =
      liquid.momentum_rate ? -*liquid.momentum_rate : -(momentum - before) / scene_.fluid.time_step;
  for (std::size_t t = 0; t < ForceBalance::terms; ++t) sum_.force[t] += now.force[t];
  ++steps_;
  // Spheres may be as heavy as the liquid that they displace.
  const double weight =
      std::max(std::abs(now.force[ForceBalance::buoyant_weight]), 1e-3 * gravitational_acceleration * mass);
  if (weight > 0.0) largest_residual_ = std::max(largest_residual_, std::abs(now.residual() / weight));
}

void MeanForceBalance::take(BedSeries& bed) {
  const std::array<std::vector<double>*, ForceBalance::terms> columns{
      &bed.pressure_force, &bed.buoyant_weight, &bed.bottom_force,   &bed.wall_force,
      &bed.shear_force,    &bed.flow_force,     &bed.sphere_inertia, &bed.liquid_inertia};
  for (std::size_t t = 0; t < ForceBalance::terms; ++t) columns[t]->push_back(sum_.force[t] / std::max(1.0, steps_));
  bed.balance_residual.push_back(largest_residual_);
  sum_ = {};
  steps_ = largest_residual_ = 0.0;
}

void MeanForceBalance::exchange(io::StateGroup& group) {
  constexpr std::array<const char*, ForceBalance::terms> names{
      "pressure", "buoyant_weight", "bottom", "walls", "shear", "flow", "sphere_inertia", "liquid_inertia"};
  for (std::size_t t = 0; t < ForceBalance::terms; ++t) group.value(names[t], sum_.force[t], "N");
  group.value("steps", steps_);
  group.value("largest_residual", largest_residual_, "1");
  group.value("liquid_momentum", liquid_momentum_, "kg m s-1");
  group.value("momentum_is_known", momentum_is_known_);
}

}  // namespace slfb::simulation
