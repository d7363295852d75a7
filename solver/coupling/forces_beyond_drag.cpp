#include "solver/coupling/forces_beyond_drag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "solver/coupling/forces/added_mass.hpp"
#include "solver/coupling/forces/magnus_lift.hpp"
#include "solver/coupling/forces/saffman_lift.hpp"

namespace slfb::coupling {
namespace {

Vec3 at(const dem::VectorField& field, std::size_t i) { return {field.x[i], field.y[i], field.z[i]}; }

}  // namespace

ForcesBeyondDrag::ForcesBeyondDrag(const Scene& scene, double time_step)
    : coupling_(scene.coupling),
      liquid_{scene.liquid.density, scene.liquid.viscosity},
      time_step_(time_step),
      any_(coupling_.added_mass > 0.0 || coupling_.saffman_lift || coupling_.magnus_lift || coupling_.basset_history ||
           coupling_.disturbance_correction),
      disturbance_(liquid_) {
  if (coupling_.basset_history) history_.emplace(time_step);
}

void ForcesBeyondDrag::start_step(dem::Particles& particles,
                                  const std::array<std::vector<double>, 3>& liquid_velocity) {
  liquid_before_.swap(liquid_now_);
  sphere_before_.swap(sphere_now_);
  const std::size_t known = sphere_before_.size(), n = particles.size();
  liquid_now_.resize(n);
  sphere_now_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    liquid_now_[i] = {liquid_velocity[0][i], liquid_velocity[1][i], liquid_velocity[2][i]};
    sphere_now_[i] = at(particles.velocity, i);
    particles.added_mass[i] = AddedMass{coupling_.added_mass, liquid_.density, particles.volume(i)}.inertia();
  }
  // A new sphere has no past: its liquid and itself have not accelerated.
  for (std::size_t i = known; i < n; ++i) {
    liquid_before_.push_back(liquid_now_[i]);
    sphere_before_.push_back(sphere_now_[i]);
  }
  self_induced_.resize(n);
  if (!history_) return;
  for (std::size_t i = 0; i < history_->size(); ++i) history_->advance(i, liquid_now_[i] - sphere_now_[i]);
  if (history_->size() > 0) history_->end_step();
  for (std::size_t i = history_->size(); i < n; ++i) history_->add(liquid_now_[i] - sphere_now_[i]);
}

void ForcesBeyondDrag::remove(std::size_t i) {
  if (i >= sphere_now_.size()) return;
  for (auto* vectors : {&self_induced_, &liquid_before_, &sphere_before_, &liquid_now_, &sphere_now_})
    if (i < vectors->size()) vectors->erase(vectors->begin() + static_cast<std::ptrdiff_t>(i));
  if (history_) history_->remove(i);
}

ForcesBeyondDrag::Effect ForcesBeyondDrag::effect(const dem::Particles& particles, std::size_t i,
                                                  const Surroundings& surroundings) const {
  const double diameter = 2.0 * particles.radius[i];
  const Vec3 sphere = sphere_now_[i], slip = surroundings.velocity - sphere;
  Effect effect;
  if (coupling_.saffman_lift) effect.force = effect.force + mei_lift(slip, surroundings.vorticity(), diameter, liquid_);
  if (coupling_.magnus_lift)
    effect.force = effect.force + oesterle_bui_dinh_lift(
                                      relative_rotation(surroundings.vorticity(), at(particles.angular_velocity, i)),
                                      slip, diameter, liquid_);
  if (history_) {
    const double coefficient = basset_coefficient(diameter, liquid_);
    effect.force = effect.force + coefficient * history_->memory(i);
    effect.coefficient = coefficient * history_->weight();
  }
  effect.reaction = -1.0 * effect.force;
  if (coupling_.added_mass > 0.0) {
    const AddedMass added{coupling_.added_mass, liquid_.density, particles.volume(i)};
    // Along the liquid's own way: what changed along the sphere's, and the slip's convection.
    const Vec3 convection{dot(slip, surroundings.gradient[0]), dot(slip, surroundings.gradient[1]),
                          dot(slip, surroundings.gradient[2])};
    const Vec3 force = added.force_of_liquid((1.0 / time_step_) * (liquid_now_[i] - liquid_before_[i]) + convection);
    effect.force = effect.force + force;
    effect.reaction = effect.reaction - force + (added.inertia() / time_step_) * (sphere - sphere_before_[i]);
  }
  return effect;
}

Vec3 ForcesBeyondDrag::change_of_angular_velocity(const dem::Particles& particles, std::size_t i,
                                                  const Surroundings& surroundings) const {
  const Vec3 rotation = relative_rotation(surroundings.vorticity(), at(particles.angular_velocity, i));
  const double turning = norm(rotation);
  if (!coupling_.magnus_lift || turning == 0.0) return {};
  const Vec3 torque = viscous_torque(rotation, 2.0 * particles.radius[i], liquid_);
  return (time_step_ / (particles.inertia(i) + time_step_ * norm(torque) / turning)) * torque;
}

double ForcesBeyondDrag::momentum_on_its_way(const dem::Particles& particles, std::size_t a) const {
  const std::array<const std::vector<double>*, 3> velocity{&particles.velocity.x, &particles.velocity.y,
                                                           &particles.velocity.z};
  const std::array<double Vec3::*, 3> component{&Vec3::x, &Vec3::y, &Vec3::z};
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(sphere_now_.size(), particles.size()); ++i)
    sum += particles.added_mass[i] * ((*velocity[a])[i] - sphere_now_[i].*component[a]);
  return sum;
}

void ForcesBeyondDrag::disturb(std::size_t i, Vec3 force_on_liquid, double concentration, double voidage, double slip) {
  self_induced_[i] = disturbance_.advance(self_induced_[i], force_on_liquid, concentration, voidage, slip, time_step_);
}

NamedFields ForcesBeyondDrag::state() const {
  NamedFields state;
  const auto write = [&](const std::string& name, const std::vector<Vec3>& vectors) {
    auto &x = state[name + "_x"], &y = state[name + "_y"], &z = state[name + "_z"];
    for (const Vec3& v : vectors) x.push_back(v.x), y.push_back(v.y), z.push_back(v.z);
  };
  write("self_induced", self_induced_);
  write("liquid_velocity", liquid_now_);
  write("sphere_velocity", sphere_now_);
  if (history_) {
    const BassetHistory::State history = history_->state();
    state["basset_history"] = history.spheres;
    state["basset_newest"] = {static_cast<double>(history.newest)};
  }
  return state;
}

void ForcesBeyondDrag::restore(const NamedFields& state, std::size_t spheres) {
  const auto read = [&](const std::string& name, std::vector<Vec3>& vectors) {
    const auto& x = field_of(state, name + "_x");
    // A sphere that has just been released is not known here yet.
    if (x.size() > spheres)
      throw std::runtime_error(
          fmt::format("the field \"{}_x\" of the state has {} values for {} spheres", name, x.size(), spheres));
    const auto &y = field_of(state, name + "_y", x.size()), &z = field_of(state, name + "_z", x.size());
    vectors.clear();
    for (std::size_t i = 0; i < x.size(); ++i) vectors.push_back({x[i], y[i], z[i]});
  };
  read("self_induced", self_induced_);
  read("liquid_velocity", liquid_now_);
  read("sphere_velocity", sphere_now_);
  if (!history_) return;
  history_->restore(
      {field_of(state, "basset_history"), index_of(state, "basset_newest", 0, std::numeric_limits<int>::max())});
  if (history_->size() > spheres)
    throw std::runtime_error(fmt::format("the field \"basset_history\" of the state has {} spheres instead of {}",
                                         history_->size(), spheres));
}

}  // namespace slfb::coupling
