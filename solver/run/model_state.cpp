// What a checkpoint holds of spheres, liquid and their exchange.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/run/model.hpp"

namespace slfb::simulation {
namespace {

void exchange_vectors(io::StateGroup& group, const std::string& name, dem::VectorField& field, const std::string& unit,
                      std::size_t length) {
  group.part(name, [&](io::StateGroup& components) {
    components.values("x", field.x, unit, length);
    components.values("y", field.y, unit, length);
    components.values("z", field.z, unit, length);
  });
}

/// A state that its owner gives and takes by name. The owner's restore finds what is missing; names that the owner does
/// not have, and lengths other than those at the start, are found here.
template <class Owner, class Restore>
void exchange_fields(io::StateGroup& group, const Owner& owner, Restore restore) {
  const NamedFields present = owner.state();
  if (!group.reading()) return group.write_fields(present);
  const NamedFields read = group.read_fields();
  for (const auto& [name, values] : present) {
    const auto found = read.find(name);
    if (found != read.end() && !values.empty() && !found->second.empty() && found->second.size() != values.size())
      group.fail(name, fmt::format("has {} values instead of {}", found->second.size(), values.size()));
  }
  try {
    restore(read);
  } catch (const std::exception& error) {
    group.fail("", fmt::format("cannot be restored: {}", error.what()));
  }
  const NamedFields restored = owner.state();
  for (const auto& [name, values] : read)
    if (!restored.contains(name)) group.fail(name, "is not a name of this state");
}

/// Contacts of `spheres` spheres, with each other or with walls, as one array per property.
void exchange_contacts(io::StateGroup& group, std::vector<dem::ContactRecord>& records, std::size_t spheres,
                       bool at_walls) {
  using Record = dem::ContactRecord;
  const auto number = [&](const std::string& name, std::uint32_t Record::*property, std::optional<std::size_t> length) {
    std::vector<std::int64_t> values;
    values.reserve(records.size());
    for (const Record& record : records) values.push_back(record.*property);
    group.values(name, values, length);
    records.resize(values.size());
    for (std::size_t c = 0; c < records.size(); ++c) records[c].*property = static_cast<std::uint32_t>(values[c]);
  };
  const auto vector = [&](const std::string& name, Vec3 Record::*property, const std::string& unit) {
    dem::VectorField field;
    for (const Record& record : records) {
      field.x.push_back((record.*property).x);
      field.y.push_back((record.*property).y);
      field.z.push_back((record.*property).z);
    }
    exchange_vectors(group, name, field, unit, records.size());
    for (std::size_t c = 0; c < records.size(); ++c) records[c].*property = {field.x[c], field.y[c], field.z[c]};
  };
  number("first", &Record::first, {});
  number("second", &Record::second, records.size());
  for (const Record& record : records)
    if (record.first >= spheres || (!at_walls && record.second >= spheres))
      group.fail("", fmt::format("has a contact of spheres {} and {}, but there are {}", record.first, record.second,
                                 spheres));
  number("first_step", &Record::first_step, records.size());
  vector("spring", &Record::spring, "m");
  vector("rolling_memory", &Record::rolling_memory, "N m");
  std::vector<double> impact_speed;
  impact_speed.reserve(records.size());
  for (const Record& record : records) impact_speed.push_back(record.impact_speed);
  group.values("impact_speed", impact_speed, "m s-1", records.size());
  for (std::size_t c = 0; c < records.size(); ++c) records[c].impact_speed = impact_speed[c];
}

void exchange_particles(io::StateGroup& group, dem::Particles& particles) {
  group.values("radius", particles.radius, "m");
  const std::size_t n = particles.radius.size();
  group.values("mass", particles.mass, "kg", n);
  group.values("added_mass", particles.added_mass, "kg", n);
  std::vector<std::int64_t> species(particles.species.begin(), particles.species.end());
  group.values("species", species, n);
  particles.species.assign(species.begin(), species.end());
  exchange_vectors(group, "position", particles.position, "m", n);
  exchange_vectors(group, "velocity", particles.velocity, "m s-1", n);
  exchange_vectors(group, "angular_velocity", particles.angular_velocity, "rad s-1", n);
}

void exchange_memory(io::StateGroup& group, dem::Engine::Memory& memory, std::size_t n) {
  group.value("steps", memory.steps);
  group.part("sphere_contacts",
             [&](io::StateGroup& contacts) { exchange_contacts(contacts, memory.contacts, n, false); });
  group.part("wall_contacts",
             [&](io::StateGroup& contacts) { exchange_contacts(contacts, memory.wall_contacts, n, true); });
  group.values("contact_events", memory.contact_events, n);
  exchange_vectors(group, "mean_solid_force", memory.mean_solid_force, "N", n);
  group.values("integrator", memory.integrator);
  group.part("neighbour_list", [&](io::StateGroup& list) {
    exchange_vectors(list, "position", memory.list_position, "m", n);
    list.value("skin", memory.skin, "m");
    list.value("travel", memory.travel, "m");
    list.value("margin", memory.margin, "m");
    list.value("step", memory.list_step);
  });
}

}  // namespace

void Model::exchange_engine(io::StateGroup& group) {
  dem::Particles particles;
  dem::Engine::Memory memory;
  std::int64_t dropped = dropped_ ? static_cast<std::int64_t>(*dropped_) : -1;
  if (!group.reading()) {
    particles = engine_.particles;
    memory = engine_.memory();
  }
  group.part("particles", [&](io::StateGroup& part) { exchange_particles(part, particles); });
  const std::size_t n = particles.size();
  group.part("memory", [&](io::StateGroup& part) { exchange_memory(part, memory, n); });
  group.value("dropped", dropped);
  if (!group.reading()) return;
  if (dropped >= static_cast<std::int64_t>(n)) group.fail("dropped", fmt::format("is sphere {} of {}", dropped, n));
  try {
    engine_.restore(std::move(particles), memory);
  } catch (const dem::EngineError& error) {
    group.fail("memory", fmt::format("cannot be restored: {}", error.what()));
  }
  dropped_.reset();
  if (dropped >= 0) dropped_ = static_cast<std::size_t>(dropped);
  engine_.track(dropped_);
}

void Model::exchange(io::StateGroup& state) {
  state.part("spheres", [&](io::StateGroup& group) { exchange_engine(group); });
  if (liquid_->two_way())
    state.part("liquid", [&](io::StateGroup& group) {
      exchange_fields(group, *liquid_, [&](const NamedFields& fields) { liquid_->restore(fields); });
    });
  const auto exchange_coupling = [&](const char* name, coupling::PhaseCoupling& coupling) {
    state.part(name, [&](io::StateGroup& group) {
      exchange_fields(group, coupling, [&](const NamedFields& fields) { coupling.restore(fields, engine_.particles); });
    });
  };
  exchange_coupling("exchange_at_rest", *resting_);
  exchange_coupling("exchange_in_flow", *flowing_);
}

}  // namespace slfb::simulation
