#include "solver/dem/engine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/dem/engine_internals.hpp"

namespace slfb::dem {
namespace {

constexpr std::uint32_t bottom_wall = 0;

}  // namespace

/// Position, velocity and angular velocity of the second sphere of a pair, or of the nearest point of a wall.
struct Engine::SecondBody {
  Pack position, velocity, angular_velocity;
};

Engine::Engine(const Contact& contact, const ContactLawKernels& law, std::vector<Wall> walls,
               std::array<double, 3> period, int threads)
    : contact_(contact),
      wall_contact_(contact.at_wall()),
      walls_(std::move(walls)),
      period_(period),
      time_step_(contact.time_step),
      threads_(threads),
      periodic_(period[0] > 0.0 || period[1] > 0.0 || period[2] > 0.0),
      law_(law),
      rolling_(rolling_index(contact)),
      wall_rolling_(rolling_index(wall_contact_)),
      rolling_remembers_((contact.rolling_friction > 0.0 || wall_contact_.rolling_friction > 0.0) &&
                         contact.rolling_model == RollingModel::elastic_plastic) {
  switch (contact.integrator) {
    case Integrator::symplectic_euler:
      choose_integrator<SymplecticEuler>();
      break;
    case Integrator::velocity_verlet:
      choose_integrator<VelocityVerlet>();
      break;
    case Integrator::position_verlet:
      choose_integrator<PositionVerlet>();
      break;
    case Integrator::gear:
      choose_integrator<Gear>();
      break;
  }
  for (int image = 0; image < 27; ++image) {
    const int x = image % 3 - 1, y = image / 3 % 3 - 1, z = image / 9 - 1;
    image_shift_[static_cast<std::size_t>(image)] = {x * period[0], y * period[1], z * period[2], 0.0};
  }
  for (int t = 0; t < threads; ++t) partitions_.push_back(std::make_unique<ThreadPartition>());
}

Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;

template <class Integrator>
void Engine::choose_integrator() {
  integrator_size_ = Integrator::memory_size;
  spring_phase_ = Integrator::spring_phase;
  move_ = &Engine::move<Integrator>;
  predict_ = &Engine::predict<Integrator>;
  static_assert(Integrator::memory_size <= std::tuple_size_v<decltype(WallImpulse::memory)>);
  if constexpr (Integrator::memory_size > 0) integrate_wall_forces_ = &Engine::integrate_wall_forces<Integrator>;
}

// --- spheres ---------------------------------------------------------------------------------------------------------

std::size_t Engine::add_particle(const std::array<double, 3>& centre, double radius, double density, int species) {
  finish_collisions();
  const Records records = contact_records();
  integrator_memory_by_number();
  const std::size_t i = particles.add(centre, radius, density, species);
  resize_particle_arrays();
  if (list_valid_) rebuild_from_particles(records);
  return i;
}

void Engine::remove_particle(std::size_t i) {
  finish_collisions();
  Records records = contact_records();
  std::erase_if(records.spheres, [i](const ContactRecord& c) { return c.first == i || c.second == i; });
  std::erase_if(records.walls, [i](const ContactRecord& c) { return c.first == i; });
  for (ContactRecord& c : records.spheres) {
    if (c.first > i) --c.first;
    if (c.second > i) --c.second;
  }
  for (ContactRecord& c : records.walls)
    if (c.first > i) --c.first;
  integrator_memory_by_number();
  particles.remove(i);
  for (auto* field : {&external_force, &mean_solid_force_}) field->erase(i);
  const auto at = [i](auto& values, std::size_t per_sphere) {
    return values.begin() + static_cast<std::ptrdiff_t>(i * per_sphere);
  };
  contacts_.erase(at(contacts_, 1));
  contact_events_.erase(at(contact_events_, 1));
  integrator_memory_.erase(at(integrator_memory_, integrator_size_),
                           at(integrator_memory_, integrator_size_) + static_cast<std::ptrdiff_t>(integrator_size_));
  if (tracked_ == i) tracked_.reset();
  if (tracked_ && *tracked_ > i) --*tracked_;
  if (list_valid_) rebuild_from_particles(records);
}

void Engine::resize_particle_arrays() {
  const std::size_t n = particles.size();
  for (auto* field : {&external_force, &mean_solid_force_}) field->resize(n);
  contacts_.resize(n, 0);
  contact_events_.resize(n, 0);
  integrator_memory_.resize(n * integrator_size_);
}

/// Lays the memory of the integrator out by the numbers of the spheres, for a change of their number.
void Engine::integrator_memory_by_number() {
  if (list_valid_) permute(integrator_memory_, slot_of_, integrator_size_, vector_scratch_);
}

bool Engine::moved_by_caller(std::size_t s) const {
  const Vec3 x = particles.position.vector(order_[s]);
  return x.x != position_[s].x || x.y != position_[s].y || x.z != position_[s].z;
}

/// Takes the state from `particles`; if a caller moved a sphere, the neighbour list is checked before the next step.
void Engine::pack() {
  bool moved = false;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(|| : moved)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    fetch_ahead(i, position_, velocity_, angular_velocity_, external_acceleration_);
    const std::size_t s = slot_of_[i];
    const Vec3 x = particles.position.vector(i), v = particles.velocity.vector(i),
               w = particles.angular_velocity.vector(i);
    const double inverse_mass = 1.0 / particles.inertial_mass(i);
    moved = moved || moved_by_caller(s);
    position_[s] = {x.x, x.y, x.z, particles.radius[i]};
    velocity_[s] = {v.x, v.y, v.z, inverse_mass};
    angular_velocity_[s] = {w.x, w.y, w.z, 1.0 / particles.inertia(i)};
    external_acceleration_[s].set(inverse_mass * external_force.vector(i));
  }
  if (moved) travel_ = std::numeric_limits<double>::infinity();
}

void Engine::unpack(std::int64_t steps) {
  last_advance_ = steps;
  const double inverse_time = 1.0 / (static_cast<double>(steps) * time_step_);
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    fetch_ahead(i, position_, velocity_, angular_velocity_, events_);
    const std::size_t s = slot_of_[i];
    const Vec3 v = velocity_[s].vector();
    const Vec3 gained = (particles.inertial_mass(i) * inverse_time) * (v - particles.velocity.vector(i));
    mean_solid_force_.set(i, gained - external_force.vector(i));
    particles.position.set(i, position_[s].vector());
    particles.velocity.set(i, v);
    particles.angular_velocity.set(i, angular_velocity_[s].vector());
    contact_events_[i] = events_[s];
    contacts_[i] = touched_[s];
  }
}

// --- a step ----------------------------------------------------------------------------------------------------------

/// Those of the pairs `first` to `last` that touch, written to `touching`, which must have room for one more than
/// there are; returns their number.
std::size_t Engine::find_touching(const PairList& list, std::uint32_t first, std::uint32_t last,
                                  std::uint32_t* touching) const {
  std::size_t count = 0;
  const auto find = [&](auto shift) {
    for (std::uint32_t p = first; p < last; ++p) {
      const Vec4 &own = position_[list.first[p]], &other = position_[list.second[p]];
      const Vec3 d = shift(other.vector() - own.vector(), p);
      const double sum = own.w + other.w;
      // Written always, kept if it touches: no branch that the processor would have to guess.
      touching[count] = p;
      count += dot(d, d) < sum * sum ? 1 : 0;
    }
  };
  if (periodic_)
    find([&](Vec3 d, std::uint32_t p) { return d + image_shift_[list.image[p]].vector(); });
  else
    find([](Vec3 d, std::uint32_t) { return d; });
  return count;
}

template <bool AtWall>
void Engine::note_deep_overlaps(const PairList& list, const std::uint32_t* touching, std::size_t size,
                                ThreadPartition& partition) const {
  ContactBatch& batch = partition.batch;
  const auto radius = [&](std::size_t k) {
    return AtWall ? batch.radius_i(k) : std::min(batch.radius_i(k), batch.radius_j(k));
  };
  // Four at a time; behind the last contact stand copies of it.
  decltype(Pack{} > Pack{}) deep{};
  for (std::size_t k = 0; k < size; k += 4) {
    const Pack overlap = load(&batch.overlap(k));
    deep |= overlap > deep_overlap * load(&batch.radius_i(k));
    if constexpr (!AtWall) deep |= overlap > deep_overlap * load(&batch.radius_j(k));
  }
  if ((deep[0] | deep[1] | deep[2] | deep[3]) == 0) return;
  for (std::size_t k = 0; k < size; ++k) {
    const double share = batch.overlap(k) / radius(k);
    if (!(share > std::max(deep_overlap, partition.deepest.share))) continue;
    const std::uint32_t p = touching[k], i = list.first[p], j = list.second[p];
    partition.deepest = {share, order_[i], AtWall ? j : order_[j], AtWall, position_[i].vector()};
    // At a wall the centre is beyond it then, which compute_walls() has found.
    if (!AtWall && share >= 1.0)
      fail("overlaps another by the whole of the smaller radius", batch.radius_i(k) < batch.radius_j(k) ? i : j);
  }
}

/// Computes the contacts `touching` of a list, a batch at a time. `second(p)` returns the second body of pair p;
/// take(k, p, force, torque_i, torque_j) is called with the result of each contact k, in order.
template <bool AtWall, class Second, class Take>
void Engine::compute(PairList& list, const std::uint32_t* touching, std::size_t count, ThreadPartition& partition,
                     StepMode mode, Second second, Take take) const {
  const ContactKernel kernel = AtWall ? law_.compute[wall_rolling_][1] : law_.compute[rolling_][0];
  const Contact& contact = AtWall ? wall_contact_ : contact_;
  const std::uint32_t step = now();
  ContactBatch& batch = partition.batch;
  partition.new_contacts.clear();
  std::size_t recorded = 0;
  for (std::size_t begin = 0; begin < count; begin += ContactBatch::capacity) {
    const std::size_t size = std::min(ContactBatch::capacity, count - begin);
    for (std::size_t k = 0; k < size; ++k) {
      const std::uint32_t p = touching[begin + k];
      if (list.last_step[p] != step - 1) {
        if (collect_collisions_ && !AtWall) finish_collision(partition, list, p);
        list.memory[p].set({});
        if (rolling_remembers_) list.rolling_memory[p] = {};
        list.first_step[p] = step;
        partition.new_contacts.push_back(static_cast<std::uint32_t>(begin + k));
      }
      list.last_step[p] = step;
    }
    for (std::size_t k = 0; k < size; k += 4) {
      // The last group is filled up by repeating its last contact.
      std::array<std::uint32_t, 4> p{};
      for (std::size_t lane = 0; lane < 4; ++lane) p[lane] = touching[begin + std::min(k + lane, size - 1)];
      const std::array<std::uint32_t, 4> i{list.first[p[0]], list.first[p[1]], list.first[p[2]], list.first[p[3]]};
      const auto from = [&](const std::vector<Vec4>& field, std::size_t lane) { return load(field[i[lane]]); };
      const std::array<SecondBody, 4> j{second(p[0]), second(p[1]), second(p[2]), second(p[3])};
      const auto memory = [&](const std::vector<Vec4>& field, std::size_t lane) { return load(field[p[lane]]); };
      batch.position_i.put(k, from(position_, 0), from(position_, 1), from(position_, 2), from(position_, 3));
      batch.position_j.put(k, j[0].position, j[1].position, j[2].position, j[3].position);
      batch.relative_velocity.put(k, from(velocity_, 0) - j[0].velocity, from(velocity_, 1) - j[1].velocity,
                                  from(velocity_, 2) - j[2].velocity, from(velocity_, 3) - j[3].velocity);
      batch.angular_velocity_i.put(k, from(angular_velocity_, 0), from(angular_velocity_, 1),
                                   from(angular_velocity_, 2), from(angular_velocity_, 3));
      batch.angular_velocity_j.put(k, j[0].angular_velocity, j[1].angular_velocity, j[2].angular_velocity,
                                   j[3].angular_velocity);
      batch.spring.put(k, memory(list.memory, 0), memory(list.memory, 1), memory(list.memory, 2),
                       memory(list.memory, 3));
      if (rolling_remembers_)
        batch.rolling_memory.put(k, memory(list.rolling_memory, 0), memory(list.rolling_memory, 1),
                                 memory(list.rolling_memory, 2), memory(list.rolling_memory, 3));
    }
    kernel(batch, (size + 3) / 4 * 4, contact, spring_phase_);
    for (std::size_t k = 0; k < size; k += 4) {
      std::array<Pack, 4> force, torque_i, torque_j, spring, rolling_memory;
      batch.force.get(k, force);
      batch.torque_i.get(k, torque_i);
      if constexpr (!AtWall) batch.torque_j.get(k, torque_j);
      batch.spring.get(k, spring);
      if (rolling_remembers_) batch.rolling_memory.get(k, rolling_memory);
      const std::size_t lanes = std::min<std::size_t>(4, size - k);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::uint32_t p = touching[begin + k + lane];
        take(begin + k + lane, p, force[lane], torque_i[lane], torque_j[lane]);
        store(list.memory[p], spring[lane]);
        if (rolling_remembers_) store(list.rolling_memory[p], rolling_memory[lane]);
      }
    }
    note_deep_overlaps<AtWall>(list, touching + begin, size, partition);
    for (; !AtWall && recorded < partition.new_contacts.size(); ++recorded) {
      const std::uint32_t k = partition.new_contacts[recorded];
      list.impact_speed[touching[k]] = batch.approach_speed(k - begin);
    }
    if (mode != StepMode::final) continue;
    for (std::size_t k = 0; k < size; ++k) {
      const std::uint32_t p = touching[begin + k];
      const double normal = batch.normal_force(k);
      list.normal_force[p] = normal;
      list.tangential_force[p] = std::sqrt(std::max(0.0, dot(batch.force.at(k), batch.force.at(k)) - normal * normal));
      const double radius = AtWall ? batch.radius_i(k) : std::min(batch.radius_i(k), batch.radius_j(k));
      partition.overlap = std::max(partition.overlap, batch.overlap(k) / radius);
    }
  }
}

template <class Take>
void Engine::compute_pairs(PairList& list, const std::uint32_t* touching, std::size_t count, ThreadPartition& partition,
                           StepMode mode, Take take) const {
  const auto second = [&](std::uint32_t p) {
    const std::uint32_t j = list.second[p];
    return SecondBody{load(position_[j]), load(velocity_[j]), load(angular_velocity_[j])};
  };
  const auto second_image = [&](std::uint32_t p) {
    SecondBody body = second(p);
    body.position += load(image_shift_[list.image[p]]);
    return body;
  };
  if (periodic_)
    compute<false>(list, touching, count, partition, mode, second_image, take);
  else
    compute<false>(list, touching, count, partition, mode, second, take);
}

/// Contacts with the walls: the first terms of the sums.
void Engine::compute_walls(ThreadPartition& partition, StepMode mode) {
  PairList& list = partition.wall;
  std::size_t count = 0;
  for (std::uint32_t p = 0; p < list.second.size(); ++p) {
    const Vec4& own = position_[list.first[p]];
    const Wall& wall = walls_[list.second[p]];
    if (wall.clear_of(own.vector(), own.w)) continue;
    const Wall::Gap gap = wall.gap(own.vector());
    if (!(gap.distance > 0.0)) fail("has gone through a wall", list.first[p]);
    if (gap.distance >= own.w) continue;
    partition.wall_point[p].set(own.vector() + gap.distance * gap.outward);
    partition.touching[count++] = p;
  }
  compute<true>(
      list, partition.touching.data(), count, partition, mode,
      [&](std::uint32_t p) {
        return SecondBody{load(partition.wall_point[p]), Pack{}, Pack{}};
      },
      [&](std::size_t, std::uint32_t p, Pack force, Pack torque, Pack) {
        const std::size_t i = list.first[p];
        store(force_[i], load(force_[i]) + force);
        store(torque_[i], load(torque_[i]) + torque);
        (list.second[p] == bottom_wall ? vertical_wall_force_[i].x : vertical_wall_force_[i].y) += force[2];
        if (mode == StepMode::final) store(wall_force_[i], load(wall_force_[i]) + force);
        if (i == tracked_slot_) partition.tracked_force = partition.tracked_force - Vec3{force[0], force[1], force[2]};
      });
}

void Engine::compute_outer(ThreadPartition& partition, StepMode mode) {
  PairList& list = partition.outer;
  partition.outer_count =
      find_touching(list, 0, static_cast<std::uint32_t>(list.second.size()), partition.outer_touching.data());
  partition.outer_next = 0;
  compute_pairs(list, partition.outer_touching.data(), partition.outer_count, partition, mode,
                [&](std::size_t k, std::uint32_t, Pack force, Pack torque_i, Pack torque_j) {
                  partition.outer_effects[k] = {force, torque_i, torque_j};
                });
}

/// Adds the forces of the pairs of earlier partitions on the spheres of this one.
void Engine::add_earlier_partitions(const ThreadPartition& partition) {
  for (const auto& other : partitions_) {
    if (other.get() == &partition) return;
    for (std::size_t k = 0; k < other->outer_count; ++k) {
      const std::uint32_t p = other->outer_touching[k], j = other->outer.second[p];
      if (j < partition.first || j >= partition.last) continue;
      store(force_[j], load(force_[j]) - other->outer_effects[k].force);
      store(torque_[j], load(torque_[j]) + other->outer_effects[k].torque_j);
      ++touched_[j];
      if (other->outer.first_step[p] == now()) ++events_[j];
    }
  }
}

void Engine::sweep(ThreadPartition& partition, StepMode mode) {
  if (mode == StepMode::final)
    for (std::size_t s = partition.first; s < partition.last; ++s) wall_force_[s] = {}, touched_[s] = 0;
  if (!partition.wall.second.empty()) compute_walls(partition, mode);
  add_earlier_partitions(partition);
  partition.speed_squared = partition.speed_sum = 0.0;
  PairList& list = partition.inner;
  for (std::size_t first = partition.first; first < partition.last; first += block_size) {
    const std::size_t last = std::min(first + block_size, partition.last);
    const std::size_t count = find_touching(list, list.start[first - partition.first],
                                            list.start[last - partition.first], partition.touching.data());
    compute_pairs(list, partition.touching.data(), count, partition, mode,
                  [&](std::size_t, std::uint32_t p, Pack force, Pack torque_i, Pack torque_j) {
                    const std::uint32_t i = list.first[p], j = list.second[p];
                    store(force_[i], load(force_[i]) + force);
                    store(torque_[i], load(torque_[i]) + torque_i);
                    store(force_[j], load(force_[j]) - force);
                    store(torque_[j], load(torque_[j]) + torque_j);
                  });
    if (mode == StepMode::final)
      for (std::size_t k = 0; k < count; ++k) {
        ++touched_[list.first[partition.touching[k]]];
        ++touched_[list.second[partition.touching[k]]];
      }
    for (const std::uint32_t k : partition.new_contacts) {
      ++events_[list.first[partition.touching[k]]];
      ++events_[list.second[partition.touching[k]]];
    }
    for (; partition.outer_next < partition.outer_count; ++partition.outer_next) {
      const std::uint32_t p = partition.outer_touching[partition.outer_next], i = partition.outer.first[p];
      if (i >= last) break;
      const OuterEffect& effect = partition.outer_effects[partition.outer_next];
      store(force_[i], load(force_[i]) + effect.force);
      store(torque_[i], load(torque_[i]) + effect.torque_i);
      ++touched_[i];
      if (partition.outer.first_step[p] == now()) ++events_[i];
    }
    if (tracked_slot_ >= first && tracked_slot_ < last)
      partition.tracked_force = partition.tracked_force + force_[tracked_slot_].vector();
    (this->*move_)(partition, first, last, mode);
  }
}

template <class Integrator>
void Engine::move(ThreadPartition& partition, std::size_t first, std::size_t last, StepMode mode) {
  double speed_squared = 0.0, speed_sum = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    if (mode == StepMode::final) {
      contact_force_[i] = force_[i];
      contact_force_[i].add(-1.0 * wall_force_[i].vector());
    }
    const Body body{position_[i], velocity_[i], angular_velocity_[i],
                    integrator_memory_.data() + i * Integrator::memory_size};
    const Vec3 constant = external_acceleration_[i].vector();
    const Acceleration contact{velocity_[i].w * force_[i].vector(), angular_velocity_[i].w * torque_[i].vector()};
    if (mode == StepMode::start) {
      Integrator::start(body, contact);
      force_[i] = {};
      torque_[i] = {};
      continue;
    }
    Integrator::correct(body, contact, constant, time_step_);
    const double own = dot(velocity_[i].vector(), velocity_[i].vector());
    speed_squared = own > speed_squared ? own : speed_squared;
    speed_sum += own;
    if (mode == StepMode::middle) Integrator::predict(body, constant, time_step_);
    force_[i] = {};
    torque_[i] = {};
  }
  partition.speed_squared = std::max(partition.speed_squared, speed_squared);
  partition.speed_sum += speed_sum;
}

template <class Integrator>
void Engine::predict(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i)
    Integrator::predict(
        {position_[i], velocity_[i], angular_velocity_[i], integrator_memory_.data() + i * Integrator::memory_size},
        external_acceleration_[i].vector(), time_step_);
}

/// Integrators are linear in the forces: what the walls give to all spheres together is what a body of mass 1 gets from
/// the sum of their forces.
template <class Integrator>
void Engine::integrate_wall_forces(StepMode mode) {
  Vec3 sum;  // x bottom, y other walls
  for (const std::uint32_t s : slot_of_) sum = sum + vertical_wall_force_[s].vector();
  for (std::size_t w = 0; w < wall_impulse_.size(); ++w) {
    WallImpulse& wall = wall_impulse_[w];
    const Body body{wall.position, wall.velocity, wall.angular_velocity, wall.memory.data()};
    const double so_far = std::exchange(wall.force_so_far, w == 0 ? sum.x : sum.y);
    const Acceleration force{{0.0, 0.0, wall.force_so_far - so_far}, {}};
    if (mode == StepMode::start) {
      Integrator::start(body, force);
      continue;
    }
    Integrator::predict(body, {}, time_step_);
    Integrator::correct(body, force, {}, time_step_);
  }
}

template <class Work>
void Engine::for_partitions(Work work) {
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
  for (std::size_t t = 0; t < partitions_.size(); ++t) {
    // An exception must not leave a parallel region.
    try {
      work(*partitions_[t]);
    } catch (const EngineError& error) {
      partitions_[t]->failure = error.what();
    } catch (const std::exception& error) {
      partitions_[t]->failure =
          fmt::format("the contact law {} ({}) fails: {}", law_.info.name, contact_.law, error.what());
    } catch (...) {
      partitions_[t]->failure = fmt::format("the contact law {} ({}) throws something that is no std::exception",
                                            law_.info.name, contact_.law);
    }
  }
  for (auto& partition : partitions_)
    if (!partition->failure.empty()) throw EngineError(std::exchange(partition->failure, {}));
}

void Engine::advance(std::int64_t steps) {
  if (steps <= 0) return;
  if (particles.size() == 0) {
    steps_ += steps;
    return;
  }
  if (!list_valid_) {
    rebuild_from_particles({});
    if (integrator_size_ > 0) {
      // Integrators that restore_contacts accelerations need those of the start, when contacts may exist: a step in
      // which nothing moves, and no contact remembers that it was.
      std::ranges::fill(vertical_wall_force_, Vec4{});
      for (WallImpulse& wall : wall_impulse_) wall.force_so_far = 0.0;
      for_partitions([&](ThreadPartition& partition) { compute_outer(partition, StepMode::start); });
      for_partitions([&](ThreadPartition& partition) { sweep(partition, StepMode::start); });
      (this->*integrate_wall_forces_)(StepMode::start);
      integrator_memory_by_number();
      rebuild_from_particles({});
    }
  }
  pack();
  tracked_sum_ = {};
  for_partitions([&](ThreadPartition& partition) {
    for (std::size_t s = partition.first; s < partition.last; ++s) vertical_wall_force_[s] = {};
    (this->*predict_)(partition.first, partition.last);
  });
  for (WallImpulse& wall : wall_impulse_) wall.velocity = {}, wall.force_so_far = 0.0;
  std::int64_t done = 0;
  try {
    for (; done < steps; ++done) one_step(done + 1 == steps ? StepMode::final : StepMode::middle);
  } catch (const EngineError&) {
    unpack(done + 1);  // so that what is saved is the state that failed
    throw;
  }
  unpack(steps);
  mean_tracked_force_ = {};
  if (tracked_) {
    const Vec3 mean = (1.0 / static_cast<double>(steps)) * tracked_sum_;
    mean_tracked_force_ = {mean.x, mean.y, mean.z};
  }
}

void Engine::one_step(StepMode mode) {
  rebuild_when_needed();
  tracked_slot_ = tracked_ ? slot_of_[*tracked_] : std::numeric_limits<std::size_t>::max();

  if (lubrication_ && !lubrication_suspended_) add_lubrication();
  for (auto& partition : partitions_) partition->overlap = 0.0;
  if (threads_ > 1) for_partitions([&](ThreadPartition& partition) { compute_outer(partition, mode); });
  for_partitions([&](ThreadPartition& partition) { sweep(partition, mode); });
  if (integrate_wall_forces_ != nullptr) (this->*integrate_wall_forces_)(mode);

  double speed_squared = 0.0, speed_sum = 0.0;
  maximum_overlap_ = 0.0;
  for (auto& partition : partitions_) {
    speed_squared = std::max(speed_squared, partition->speed_squared);
    speed_sum += partition->speed_sum;
    maximum_overlap_ = std::max(maximum_overlap_, partition->overlap);
    tracked_sum_ = tracked_sum_ + std::exchange(partition->tracked_force, {});
  }
  if (!std::isfinite(speed_sum))
    for (std::size_t s = 0; s < velocity_.size(); ++s)
      if (!std::isfinite(dot(velocity_[s].vector(), velocity_[s].vector()))) fail("has no finite velocity any more", s);
  travel_ += time_step_ * std::sqrt(speed_squared);
  ++steps_;
}

/// Adds the lubrication forces to those of the coming step: sphere by sphere, and for each in the order of the others,
/// so that the sums do not depend on the partitions.
void Engine::add_lubrication() {
  std::vector<std::pair<std::uint32_t, std::uint8_t>> others;
  for (const auto& partition : partitions_)
    for (std::size_t i = partition->first; i < partition->last; ++i) {
      const Vec4 own = position_[i];
      const auto act = [&](Vec3 to_other, double touching_distance, double radius, Vec3 relative_velocity) {
        const double distance = norm(to_other);
        const Vec3 normal = (1.0 / distance) * to_other;
        return lubrication_->repulsion(distance - touching_distance, radius, dot(relative_velocity, normal)) * normal;
      };
      others.clear();
      for (const PairList* list : {&partition->inner, &partition->outer})
        for (std::uint32_t p = list->start[i - partition->first]; p < list->start[i - partition->first + 1]; ++p)
          others.emplace_back(list->second[p], list->image[p]);
      std::sort(others.begin(), others.end());
      for (const auto& [j, image] : others) {
        const Vec4 other = position_[j];
        const Vec3 force = act(other.vector() + image_shift_[image].vector() - own.vector(), own.w + other.w,
                               reduced_radius(own.w, other.w), velocity_[i].vector() - velocity_[j].vector());
        force_[i].add(-1.0 * force);
        force_[j].add(force);
      }
      const PairList& walls = partition->wall;
      for (std::uint32_t p = walls.start[i - partition->first]; p < walls.start[i - partition->first + 1]; ++p) {
        const std::uint32_t w = walls.second[p];
        const auto gap = walls_[w].gap(own.vector());
        const Vec3 force = act(gap.distance * gap.outward, own.w, own.w, velocity_[i].vector());
        force_[i].add(-1.0 * force);
        (w == bottom_wall ? vertical_wall_force_[i].x : vertical_wall_force_[i].y) -= force.z;
      }
    }
}

void Engine::fail(const char* what, std::size_t slot) const {
  const Vec4 &x = position_[slot], &v = velocity_[slot];
  throw EngineError(fmt::format(
      "sphere {} {} at step {} (t = {:.6g} s of motion): centre ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.4g}, {:.4g}, "
      "{:.4g}) m/s; a smaller contact.time_step or a larger stiffness may be needed",
      order_[slot], what, steps_, static_cast<double>(steps_) * time_step_, x.x, x.y, x.z, v.x, v.y, v.z));
}

}  // namespace slfb::dem
