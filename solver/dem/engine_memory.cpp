// What the engine remembers: contacts over a rebuilt list, and everything over a checkpoint.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "solver/dem/engine_internals.hpp"

namespace slfb::dem {

Engine::Records Engine::contact_records() const {
  Records records;
  for_contacts([&](std::uint32_t i, std::uint32_t j, const PairList& list, std::uint32_t p, bool at_wall) {
    ContactRecord record{
        order_[i],          at_wall ? j : order_[j], list.memory[p].vector(), list.rolling_memory[p].vector(),
        list.first_step[p], list.impact_speed[p]};
    if (!at_wall && record.first > record.second) {
      std::swap(record.first, record.second);
      record.spring = -1.0 * record.spring;
      record.rolling_memory = -1.0 * record.rolling_memory;
    }
    (at_wall ? records.walls : records.spheres).push_back(record);
  });
  return records;
}

void Engine::restore_contacts(const Records& records) {
  const auto touching = static_cast<std::uint32_t>(steps_);
  const auto keep = [&](std::size_t slot, std::uint32_t second, bool at_wall, const ContactRecord& record,
                        double sign) {
    std::size_t t = slot * partitions_.size() / position_.size();
    while (slot >= partitions_[t]->last) ++t;
    ThreadPartition& partition = *partitions_[t];
    PairList& list = at_wall ? partition.wall : second < partition.last ? partition.inner : partition.outer;
    const std::size_t own = slot - partition.first;
    for (std::uint32_t p = list.start[own]; p < list.start[own + 1]; ++p) {
      if (list.second[p] != second) continue;
      list.memory[p].set(sign * record.spring);
      list.rolling_memory[p].set(sign * record.rolling_memory);
      list.first_step[p] = record.first_step;
      list.last_step[p] = touching;
      list.impact_speed[p] = record.impact_speed;
    }
  };
  for (const ContactRecord& record : records.spheres) {
    const std::uint32_t a = slot_of_[record.first], b = slot_of_[record.second];
    keep(std::min(a, b), std::max(a, b), false, record, a < b ? 1.0 : -1.0);
  }
  for (const ContactRecord& record : records.walls) keep(slot_of_[record.first], record.second, true, record, 1.0);
}

Engine::Memory Engine::memory() const {
  Memory memory;
  Records records = contact_records();
  memory.contacts = std::move(records.spheres);
  memory.wall_contacts = std::move(records.walls);
  memory.contact_events = contact_events_;
  memory.mean_solid_force = mean_solid_force_;
  memory.list_position.resize(list_position_.size());
  for (std::size_t s = 0; s < list_position_.size(); ++s)
    memory.list_position.set(order_[s], list_position_[s].vector());
  memory.skin = skin_;
  memory.travel = travel_;
  for (std::size_t s = 0; list_valid_ && s < position_.size(); ++s)
    if (moved_by_caller(s)) memory.travel = std::numeric_limits<double>::infinity();
  memory.margin = margin_;
  memory.list_step = list_step_;
  memory.steps = steps_;
  for (std::size_t i = 0; i < slot_of_.size(); ++i)
    for (std::size_t k = 0; k < integrator_size_; ++k) {
      const Vec4& kept = integrator_memory_[slot_of_[i] * integrator_size_ + k];
      memory.integrator.insert(memory.integrator.end(), {kept.x, kept.y, kept.z});
    }
  for (const WallImpulse& wall : wall_impulse_)
    for (std::size_t k = 0; k < integrator_size_; ++k)
      memory.integrator.insert(memory.integrator.end(), {wall.memory[k].x, wall.memory[k].y, wall.memory[k].z});
  return memory;
}

void Engine::restore(Particles state, const Memory& memory) {
  list_valid_ = false;
  particles = std::move(state);
  resize_particle_arrays();
  contact_events_ = memory.contact_events;
  mean_solid_force_ = memory.mean_solid_force;
  steps_ = memory.steps;
  if (memory.list_position.x.size() != particles.size()) return;  // nothing had moved yet
  const std::size_t of_spheres = integrator_memory_.size(), all = of_spheres + wall_impulse_.size() * integrator_size_;
  if (memory.integrator.size() != 3 * all)
    throw EngineError(
        fmt::format("the integrator's memory has {} values instead of {}", memory.integrator.size(), 3 * all));
  for (std::size_t k = 0; k < all; ++k) {
    Vec4& kept = k < of_spheres
                     ? integrator_memory_[k]
                     : wall_impulse_[(k - of_spheres) / integrator_size_].memory[(k - of_spheres) % integrator_size_];
    kept.set({memory.integrator[3 * k], memory.integrator[3 * k + 1], memory.integrator[3 * k + 2]});
  }
  // The order of all sums comes from the positions at which the list was built.
  const VectorField now_at = std::exchange(particles.position, memory.list_position);
  rebuild_from_particles({memory.contacts, memory.wall_contacts}, memory.skin);
  particles.position = now_at;
  pack();
  list_step_ = memory.list_step;
  travel_ = memory.travel;
  margin_ = memory.margin;
}

}  // namespace slfb::dem
