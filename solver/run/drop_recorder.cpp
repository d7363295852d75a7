#include "solver/run/drop_recorder.hpp"

#include <cmath>

namespace slfb::simulation {

void DropRecorder::end_step(const Model& model) {
  if (!model.dropped()) return;
  const auto mean = model.engine().mean_contact_force_of_tracked();
  for (std::size_t a = 0; a < 3; ++a) contact_force_[a] += mean[a];
  ++steps_;
}

void DropRecorder::start_drop(const Model& model, const std::string& species, double time) {
  DropSeries drop;
  drop.release_time = time;
  drop.species = species;
  result_.drops.push_back(std::move(drop));
  if (result_.drops.size() == 1) take_snapshot(model, "release", time);
}

void DropRecorder::sample(Model& model, double time) {
  const std::size_t i = model.dropped().value();
  const dem::Particles& particles = model.particles();
  const dem::Engine& engine = model.engine();
  coupling::PhaseCoupling& coupling = model.coupling();
  DropSeries& drop = result_.drops.back();
  drop.time.push_back(time);
  drop.x.push_back(particles.position.x[i]);
  drop.y.push_back(particles.position.y[i]);
  drop.z.push_back(particles.position.z[i]);
  drop.velocity_x.push_back(particles.velocity.x[i]);
  drop.velocity_y.push_back(particles.velocity.y[i]);
  drop.velocity_z.push_back(particles.velocity.z[i]);
  const auto angular_velocity = particles.angular_velocity.at(i);
  drop.angular_speed.push_back(std::hypot(angular_velocity[0], angular_velocity[1], angular_velocity[2]));
  drop.voidage.push_back(coupling.voidage(i));
  drop.liquid_velocity_z.push_back(coupling.liquid_velocity(i, 2));
  drop.reynolds.push_back(coupling.reynolds(i));
  const auto force = engine.contact_force(i);
  drop.contact_force.push_back(std::hypot(force[0], force[1], force[2]));
  drop.contact_force_mean_x.push_back(contact_force_[0] / steps_);
  drop.contact_force_mean_y.push_back(contact_force_[1] / steps_);
  drop.contact_force_mean_z.push_back(contact_force_[2] / steps_);
  contact_force_ = {};
  steps_ = 0.0;
  drop.drag_force_z.push_back(coupling.drag_force(i, 2));
  drop.pressure_force_z.push_back(coupling.pressure_force(i, 2));
  drop.contacts.push_back(engine.contacts(i));
  drop.cumulative_contacts.push_back(static_cast<double>(engine.contact_events(i)));
}

void DropRecorder::take_snapshots(const Model& model, bool fall_is_over, double time) {
  if (result_.drops.size() != 1 || result_.bed.bed_top.empty()) return;
  const double z = model.particles().position.z[model.dropped().value()];
  const double top = result_.bed.bed_top.back();
  if (result_.snapshots.size() == 1 && z < top) take_snapshot(model, "enters", time);
  if (result_.snapshots.size() == 2 && z < 0.5 * top) take_snapshot(model, "halfway", time);
  if (fall_is_over) take_snapshot(model, "ends", time);
}

void DropRecorder::take_snapshot(const Model& model, const std::string& moment, double time) {
  constexpr double resolution = 1.0 / 65536.0;  // [m]; finer digits would only fill the file
  const dem::Particles& particles = model.particles();
  Snapshot snapshot{moment,
                    time,
                    static_cast<std::int64_t>(model.dropped().value()),
                    particles.position.x,
                    particles.position.y,
                    particles.position.z,
                    particles.radius};
  for (auto* coordinate : {&snapshot.x, &snapshot.y, &snapshot.z})
    for (double& value : *coordinate) value = resolution * std::round(value / resolution);
  result_.snapshots.push_back(std::move(snapshot));
}

void DropRecorder::exchange(io::StateGroup& group) {
  group.value("contact_force_x", contact_force_[0], "N");
  group.value("contact_force_y", contact_force_[1], "N");
  group.value("contact_force_z", contact_force_[2], "N");
  group.value("steps", steps_);
}

}  // namespace slfb::simulation
