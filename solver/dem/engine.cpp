#include "solver/dem/engine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace slfb::dem {
namespace {

/// Share of a loop over n items that belongs to thread t.
std::pair<std::size_t, std::size_t> share(std::size_t n, int t, int threads) {
  const auto parts = static_cast<std::size_t>(threads), part = static_cast<std::size_t>(t);
  return {n * part / parts, n * (part + 1) / parts};
}

Vec3 load(const VectorField& field, std::size_t i) { return {field.x[i], field.y[i], field.z[i]}; }

void store(VectorField& field, std::size_t i, Vec3 value) {
  field.x[i] = value.x;
  field.y[i] = value.y;
  field.z[i] = value.z;
}

}  // namespace

Engine::Engine(const Contact& contact, std::vector<Wall> walls, std::array<double, 3> period, int threads)
    : law_(contact),
      walls_(std::move(walls)),
      period_(period),
      time_step_(contact.time_step),
      steps_per_second_(1.0 / contact.time_step),
      threads_(threads) {}

std::size_t Engine::add_particle(const std::array<double, 3>& centre, double radius, double density, int species) {
  const auto contacts = contact_records();
  const std::size_t i = particles.add(centre, radius, density, species);
  resize_particle_arrays();
  if (list_valid_) rebuild(contacts);
  return i;
}

void Engine::resize_particle_arrays() {
  const std::size_t n = particles.size();
  for (auto* field : {&external_force, &contact_force_, &wall_force_, &torque_, &mean_contact_, &mean_wall_})
    field->resize(n);
  contacts_.resize(n, 0);
  contact_events_.resize(n, 0);
  wall_spring_.resize(n * walls_.size());
  overlap_.resize(n, 0.0);
  place_.resize(n);
  motion_.resize(n);
  for (std::size_t i = mass_class_.size(); i < n; ++i) mass_class_.push_back(mass_class(particles.mass[i]));
}

std::int64_t Engine::mass_class(double mass) {
  const auto found = std::find(masses_.begin(), masses_.end(), mass);
  if (found != masses_.end()) return found - masses_.begin();
  masses_.push_back(mass);
  root_effective_mass_.clear();
  for (const double a : masses_)
    for (const double b : masses_) root_effective_mass_.push_back(std::sqrt(a * b / (a + b)));
  return static_cast<std::int64_t>(masses_.size()) - 1;
}

void Engine::remove_particle(std::size_t i) {
  auto contacts = contact_records();
  std::erase_if(contacts, [i](const ContactRecord& c) { return c.first == i || c.second == i; });
  for (auto& c : contacts) {
    if (c.first > i) --c.first;
    if (c.second > i) --c.second;
  }
  particles.remove(i);
  for (auto* field : {&external_force, &contact_force_, &wall_force_, &torque_, &mean_contact_, &mean_wall_})
    field->erase(i);
  const auto at = [i](auto& vector) { return vector.begin() + static_cast<std::ptrdiff_t>(i); };
  contacts_.erase(at(contacts_));
  contact_events_.erase(at(contact_events_));
  overlap_.erase(at(overlap_));
  mass_class_.erase(at(mass_class_));
  place_.pop_back();
  motion_.pop_back();
  const auto walls = static_cast<std::ptrdiff_t>(walls_.size());
  const auto first = wall_spring_.begin() + static_cast<std::ptrdiff_t>(i) * walls;
  wall_spring_.erase(first, first + walls);
  rebuild(contacts);
}

std::vector<ContactRecord> Engine::contact_records() const {
  std::vector<ContactRecord> records;
  if (!list_valid_) return records;
  const auto& start = list_.start();
  for (std::uint32_t i = 0; i + 1 < start.size(); ++i)
    for (std::uint32_t p = start[i]; p < start[i + 1]; ++p)
      if (pair_state_[p] != 0) records.push_back({i, list_.second()[p], pair_[p].spring});
  return records;
}

void Engine::rebuild(const std::vector<ContactRecord>& contacts) {
  // A wide skin makes long lists, a narrow one frequent rebuilding; the optimum is flat between a third and half a
  // radius.
  double smallest_radius = 0.0;
  if (particles.size() > 0) smallest_radius = *std::min_element(particles.radius.begin(), particles.radius.end());
  list_.build(particles, 0.4 * smallest_radius, period_, threads_);
  const std::size_t pairs = list_.pairs();
  pair_state_.assign(pairs, 0);
  pair_.assign(pairs, {});
  for (const ContactRecord& contact : contacts) {
    const auto first = list_.second().begin() + list_.start()[contact.first];
    const auto last = list_.second().begin() + list_.start()[contact.first + 1];
    const auto found = std::lower_bound(first, last, contact.second);
    if (found == last || *found != contact.second) continue;
    const auto p = static_cast<std::size_t>(found - list_.second().begin());
    pair_state_[p] = 1;
    pair_[p].spring = contact.spring;
  }
  list_valid_ = true;
}

void Engine::pack(std::size_t i) {
  const auto x = particles.position.at(i);
  place_[i] = {x[0], x[1], x[2], particles.radius[i]};
  motion_[i] = {load(particles.velocity, i), load(particles.angular_velocity, i), particles.inertia(i), mass_class_[i]};
}

template <bool Periodic>
void Engine::compute_pairs(std::size_t first, std::size_t last) {
  const std::uint32_t* start = list_.start().data();
  const std::uint32_t* second = list_.second().data();
  const bool rolling = law_.resists_rolling();
  const auto classes = static_cast<std::int64_t>(masses_.size());
  std::vector<std::uint32_t> touching(64);
  for (std::size_t i = first; i < last; ++i) {
    const Place here = place_[i];
    const Motion own = motion_[i];
    const auto separation = [&](std::uint32_t p) {
      const Place& there = place_[second[p]];
      Vec3 d{there.x - here.x, there.y - here.y, there.z - here.z};
      if constexpr (Periodic) {
        if (period_[0] > 0.0) d.x -= period_[0] * std::nearbyint(d.x / period_[0]);
        if (period_[1] > 0.0) d.y -= period_[1] * std::nearbyint(d.y / period_[1]);
        if (period_[2] > 0.0) d.z -= period_[2] * std::nearbyint(d.z / period_[2]);
      }
      return d;
    };
    // First sort out who touches, without a branch that the processor would have to guess; then compute those pairs.
    const std::uint32_t begin = start[i], pairs = start[i + 1] - begin;
    touching.resize(std::max<std::size_t>(touching.size(), pairs));
    std::uint32_t contacts = 0;
    for (std::uint32_t p = begin; p < begin + pairs; ++p) {
      const Vec3 d = separation(p);
      const double sum = here.radius + place_[second[p]].radius;
      const bool touches = dot(d, d) < sum * sum;
      touching[contacts] = p;
      contacts += touches ? 1 : 0;
      if (!touches && pair_state_[p] != 0) {
        pair_state_[p] = 0;
        pair_[p].spring = {};
      }
    }
    Vec3 force, torque;
    int events = 0;
    double largest_overlap = 0.0;
    for (std::uint32_t c = 0; c < contacts; ++c) {
      const std::uint32_t p = touching[c], j = second[p];
      const Place there = place_[j];
      const Vec3 d = separation(p);
      const double sum = here.radius + there.radius;
      const double distance_squared = dot(d, d);
      const double distance = std::sqrt(distance_squared);
      const Motion other = motion_[j];
      ContactState contact;
      contact.normal = (1.0 / distance) * d;
      contact.overlap = sum - distance;
      // The contact plane halves the overlap: the lever arms add up to the distance, which conserves angular momentum.
      const double arm_i = here.radius - 0.5 * contact.overlap, arm_j = there.radius - 0.5 * contact.overlap;
      contact.relative_velocity = own.velocity - other.velocity +
                                  cross(arm_i * own.angular_velocity + arm_j * other.angular_velocity, contact.normal);
      contact.root_effective_mass =
          root_effective_mass_[static_cast<std::size_t>(own.mass_class * classes + other.mass_class)];

      PairContact& pair = pair_[p];
      const ContactForce result = law_(contact, time_step_, pair.spring);
      pair.force = result.force;
      const Vec3 lever = cross(contact.normal, result.tangential);
      Vec3 torque_on_second = arm_j * lever;
      torque = torque + arm_i * lever;
      if (rolling) {
        // Relative angular velocity of Eq. 19.
        const Vec3 rotation =
            (1.0 / sum) * (here.radius * own.angular_velocity - there.radius * other.angular_velocity);
        const double speed = norm(rotation);
        if (speed > 0.0) {
          const Vec3 direction = (1.0 / speed) * rotation;
          torque = torque -
                   law_.rolling_torque(result.normal, here.radius, own.inertia, speed, steps_per_second_) * direction;
          torque_on_second =
              torque_on_second +
              law_.rolling_torque(result.normal, there.radius, other.inertia, speed, steps_per_second_) * direction;
        }
      }
      pair.torque_on_second = torque_on_second;
      force = force + result.force;
      pair_state_[p] = pair_state_[p] == 0 ? 2 : 1;
      if (pair_state_[p] == 2) ++events;
      largest_overlap = std::max(largest_overlap, contact.overlap / std::min(here.radius, there.radius));
    }
    store(contact_force_, i, force);
    store(torque_, i, torque);
    contacts_[i] = static_cast<int>(contacts);
    contact_events_[i] += events;
    overlap_[i] = largest_overlap;
  }
}

void Engine::compute_walls(std::size_t first, std::size_t last) {
  const std::size_t walls = walls_.size();
  for (std::size_t i = first; i < last; ++i) {
    Vec3 force, torque = load(torque_, i);
    const Vec3 x = load(particles.position, i);
    const double r = particles.radius[i];
    for (std::size_t w = 0; w < walls; ++w) {
      if (walls_[w].clear_of(x, r)) {
        wall_spring_[i * walls + w] = {};
        continue;
      }
      const Wall::Gap gap = walls_[w].gap(x);
      if (!(gap.distance > 0.0)) fail("has gone through a wall", i);
      ContactState contact;
      contact.normal = gap.outward;
      contact.overlap = r - gap.distance;
      const double arm = gap.distance;
      const Vec3 spin = load(particles.angular_velocity, i);
      contact.relative_velocity = load(particles.velocity, i) + cross(arm * spin, contact.normal);
      contact.root_effective_mass = std::sqrt(particles.mass[i]);
      const ContactForce result = law_(contact, time_step_, wall_spring_[i * walls + w]);
      force = force + result.force;
      torque = torque + arm * cross(contact.normal, result.tangential);
      const double speed = norm(spin);
      if (law_.resists_rolling() && speed > 0.0)
        torque = torque -
                 (law_.rolling_torque(result.normal, r, particles.inertia(i), speed, steps_per_second_) / speed) * spin;
      overlap_[i] = std::max(overlap_[i], contact.overlap / r);
    }
    store(wall_force_, i, force);
    store(torque_, i, torque);
  }
}

void Engine::gather_and_move(std::size_t first, std::size_t last, double& displacement_squared) {
  const auto& reverse_start = list_.reverse_start();
  const std::uint32_t* reverse = list_.reverse_pair().data();
  const VectorField& origin = list_.origin();
  for (std::size_t i = first; i < last; ++i) {
    Vec3 force = load(contact_force_, i), torque = load(torque_, i);
    for (std::uint32_t r = reverse_start[i]; r < reverse_start[i + 1]; ++r) {
      const std::uint32_t p = reverse[r];
      if (pair_state_[p] == 0) continue;
      force = force - pair_[p].force;
      torque = torque + pair_[p].torque_on_second;
      ++contacts_[i];
      if (pair_state_[p] == 2) ++contact_events_[i];
    }
    store(contact_force_, i, force);
    const Vec3 wall = load(wall_force_, i);
    mean_contact_.x[i] += force.x;
    mean_contact_.y[i] += force.y;
    mean_contact_.z[i] += force.z;
    mean_wall_.x[i] += wall.x;
    mean_wall_.y[i] += wall.y;
    mean_wall_.z[i] += wall.z;

    const Vec3 total = force + wall + load(external_force, i);
    const Vec3 velocity = load(particles.velocity, i) + (time_step_ / particles.mass[i]) * total;
    const Vec3 spin = load(particles.angular_velocity, i) + (time_step_ / particles.inertia(i)) * torque;
    const Vec3 position = load(particles.position, i) + time_step_ * velocity;
    store(particles.velocity, i, velocity);
    store(particles.angular_velocity, i, spin);
    store(particles.position, i, position);
    const Vec3 moved = position - load(origin, i);
    const double moved_squared = dot(moved, moved);
    if (!(moved_squared < 1.0)) fail("has no finite position any more", i);
    displacement_squared = std::max(displacement_squared, moved_squared);
  }
}

void Engine::step() {
  if (!list_valid_) rebuild({});
  // Whoever set a velocity or a position since the last step did so in `particles`.
  for (std::size_t i = 0; i < particles.size(); ++i) pack(i);
  const bool periodic = period_[0] > 0.0 || period_[1] > 0.0 || period_[2] > 0.0;
  const std::size_t n = particles.size();
  double displacement_squared = 0.0;
  // An exception must not leave a parallel region: keep the first and throw it afterwards.
  std::vector<std::string> failure(static_cast<std::size_t>(threads_));
#pragma omp parallel num_threads(threads_) reduction(max : displacement_squared)
  {
#pragma omp for schedule(static, 1)
    for (int t = 0; t < threads_; ++t) {
      const auto [first, last] = share(n, t, threads_);
      try {
        if (periodic)
          compute_pairs<true>(first, last);
        else
          compute_pairs<false>(first, last);
        compute_walls(first, last);
      } catch (const EngineError& error) {
        failure[static_cast<std::size_t>(t)] = error.what();
      }
    }
#pragma omp for schedule(static, 1)
    for (int t = 0; t < threads_; ++t) {
      const auto [first, last] = share(n, t, threads_);
      try {
        gather_and_move(first, last, displacement_squared);
      } catch (const EngineError& error) {
        failure[static_cast<std::size_t>(t)] = error.what();
      }
    }
  }
  for (const auto& message : failure)
    if (!message.empty()) throw EngineError(message);
  maximum_overlap_ = overlap_.empty() ? 0.0 : *std::max_element(overlap_.begin(), overlap_.end());
  ++averaged_steps_;
  ++steps_;
  if (list_.outdated(displacement_squared)) {
    if (periodic) {
      const auto wrap = [](std::vector<double>& coordinate, double period) {
        if (period <= 0.0) return;
        for (double& value : coordinate) value -= period * std::nearbyint(value / period);
      };
      wrap(particles.position.x, period_[0]);
      wrap(particles.position.y, period_[1]);
      wrap(particles.position.z, period_[2]);
    }
    rebuild(contact_records());
  }
}

void Engine::fail(const char* what, std::size_t i) const {
  throw EngineError(fmt::format(
      "sphere {} {} at step {} (t = {:.6g} s of motion): centre ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.4g}, {:.4g}, "
      "{:.4g}) m/s; a smaller contact.time_step or a larger contact.stiffness may be needed",
      i, what, steps_, static_cast<double>(steps_) * time_step_, particles.position.x[i], particles.position.y[i],
      particles.position.z[i], particles.velocity.x[i], particles.velocity.y[i], particles.velocity.z[i]));
}

void Engine::reset_mean_forces() {
  mean_contact_.set_zero();
  mean_wall_.set_zero();
  averaged_steps_ = 0;
}

std::array<double, 3> Engine::mean_contact_force(std::size_t i) const {
  const double inverse = averaged_steps_ > 0 ? 1.0 / static_cast<double>(averaged_steps_) : 0.0;
  return {mean_contact_.x[i] * inverse, mean_contact_.y[i] * inverse, mean_contact_.z[i] * inverse};
}

std::array<double, 3> Engine::mean_wall_force(std::size_t i) const {
  const double inverse = averaged_steps_ > 0 ? 1.0 / static_cast<double>(averaged_steps_) : 0.0;
  return {mean_wall_.x[i] * inverse, mean_wall_.y[i] * inverse, mean_wall_.z[i] * inverse};
}

bool Engine::touches_wall(std::size_t i, std::size_t wall) const {
  return walls_[wall].gap(load(particles.position, i)).distance < particles.radius[i];
}

Engine::Memory Engine::memory() const {
  Memory memory;
  memory.contacts = contact_records();
  memory.wall_springs.reserve(3 * wall_spring_.size());
  for (const Vec3& spring : wall_spring_)
    memory.wall_springs.insert(memory.wall_springs.end(), {spring.x, spring.y, spring.z});
  memory.contact_events = contact_events_;
  memory.mean_contact = mean_contact_;
  memory.mean_wall = mean_wall_;
  memory.averaged_steps = averaged_steps_;
  memory.steps = steps_;
  return memory;
}

void Engine::restore(Particles state, const Memory& memory) {
  particles = std::move(state);
  mass_class_.clear();
  resize_particle_arrays();
  for (std::size_t s = 0; s < wall_spring_.size(); ++s)
    wall_spring_[s] = {memory.wall_springs[3 * s], memory.wall_springs[3 * s + 1], memory.wall_springs[3 * s + 2]};
  contact_events_ = memory.contact_events;
  mean_contact_ = memory.mean_contact;
  mean_wall_ = memory.mean_wall;
  averaged_steps_ = memory.averaged_steps;
  steps_ = memory.steps;
  rebuild(memory.contacts);
}

}  // namespace slfb::dem
