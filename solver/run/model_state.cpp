// What a checkpoint holds of spheres, liquid and their exchange.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
    if (found != read.end() && !values.empty() && found->second.size() != values.size())
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
    if (!std::ranges::all_of(values, [](std::int64_t value) { return std::in_range<std::uint32_t>(value); }))
      group.fail(name, "holds a value that is no index");
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
    if (record.first >= spheres || (!at_walls && (record.second >= spheres || record.first == record.second)))
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

/// Within what a sphere could have reached: far above a column without a lid, but never this many columns away.
void check_positions(const io::StateGroup& group, const std::string& name, const dem::VectorField& position,
                     const Scene& scene) {
  constexpr double columns = 1e4;
  const double farthest = columns * std::max({scene.geometry.height, scene.geometry.diameter, scene.geometry.width[0],
                                              scene.geometry.width[1]});
  for (const auto* coordinate : {&position.x, &position.y, &position.z})
    for (const double value : *coordinate)
      if (!(std::abs(value) <= farthest))
        group.fail(name, fmt::format("has a sphere at {:g} m, {:g} times the size of the column", value,
                                     columns * std::abs(value) / farthest));
}

void exchange_particles(io::StateGroup& group, dem::Particles& particles, const Scene& scene) {
  group.values("radius", particles.radius, "m");
  const std::size_t n = particles.radius.size();
  group.values("mass", particles.mass, "kg", n);
  group.values("added_mass", particles.added_mass, "kg", n);
  std::vector<std::int64_t> species(particles.species.begin(), particles.species.end());
  group.values("species", species, n);
  if (group.reading())
    for (std::size_t i = 0; i < n; ++i) {
      if (species[i] < 0 || species[i] >= static_cast<std::int64_t>(scene.species.size()))
        group.fail("species",
                   fmt::format("has a sphere of species {}, but there are {}", species[i], scene.species.size()));
      if (particles.radius[i] != 0.5 * scene.species[static_cast<std::size_t>(species[i])].diameter)
        group.fail("radius", fmt::format("has {} m for a sphere of another diameter", particles.radius[i]));
      if (!(particles.mass[i] > 0.0) || !(particles.added_mass[i] >= 0.0))
        group.fail("mass", fmt::format("has a sphere of {} kg", particles.mass[i]));
    }
  particles.species.assign(species.begin(), species.end());
  exchange_vectors(group, "position", particles.position, "m", n);
  if (group.reading()) check_positions(group, "position", particles.position, scene);
  exchange_vectors(group, "velocity", particles.velocity, "m s-1", n);
  exchange_vectors(group, "angular_velocity", particles.angular_velocity, "rad s-1", n);
}

double largest_diameter(const Scene& scene) { return std::ranges::max(scene.species, {}, &Species::diameter).diameter; }

void exchange_memory(io::StateGroup& group, dem::Engine::Memory& memory, std::size_t n, const Scene& scene) {
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  group.value("steps", memory.steps, 0, any);
  group.part("sphere_contacts",
             [&](io::StateGroup& contacts) { exchange_contacts(contacts, memory.contacts, n, false); });
  group.part("wall_contacts",
             [&](io::StateGroup& contacts) { exchange_contacts(contacts, memory.wall_contacts, n, true); });
  group.values("contact_events", memory.contact_events, n);
  exchange_vectors(group, "mean_solid_force", memory.mean_solid_force, "N", n);
  group.values("integrator", memory.integrator);
  group.part("neighbour_list", [&](io::StateGroup& list) {
    exchange_vectors(list, "position", memory.list_position, "m", n);
    if (list.reading()) check_positions(list, "position", memory.list_position, scene);
    list.value("skin", memory.skin, "m");
    if (list.reading() && !(memory.skin >= 0.0 && memory.skin <= largest_diameter(scene)))
      list.fail("skin", fmt::format("is {} m", memory.skin));
    // Infinite where a caller has moved a sphere: the list is then looked through before the next step.
    bool moved_by_caller = std::isinf(memory.travel);
    double travel = moved_by_caller ? 0.0 : memory.travel;
    list.value("moved_by_caller", moved_by_caller);
    list.value("travel", travel, "m");
    memory.travel = moved_by_caller ? std::numeric_limits<double>::infinity() : travel;
    list.value("margin", memory.margin, "m");
    list.value("step", memory.list_step, 0, memory.steps);
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
  group.part("particles", [&](io::StateGroup& part) { exchange_particles(part, particles, scene_); });
  const std::size_t n = particles.size();
  group.part("memory", [&](io::StateGroup& part) { exchange_memory(part, memory, n, scene_); });
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
