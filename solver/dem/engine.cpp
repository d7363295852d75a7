#include "solver/dem/engine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace slfb::dem {
namespace {

/// Spheres whose contacts are computed together: some hundred contacts, which fit the first cache.
constexpr std::size_t block_size = 32;

/// The skin balances the pairs that a step looks at in vain, about 10 skin/d per sphere, against rebuilding the list,
/// which costs as much as looking at this many pairs times two.
constexpr double rebuild_cost = 15.0;
constexpr double least_skin = 0.02, largest_skin = 0.4;  ///< over the smallest diameter

/// Each of two spheres may come nearer by half the skin; a little is kept for what the bound of the travel leaves out.
constexpr double usable_skin = 0.49;

/// Steps after which the list is rebuilt even if nothing has moved far: the skin of a bed at rest can then shrink.
constexpr std::int64_t longest_list_life = 1000;

constexpr std::uint32_t bottom_wall = 0;

Vec3 load(const VectorField& field, std::size_t i) { return {field.x[i], field.y[i], field.z[i]}; }

void store(VectorField& field, std::size_t i, Vec3 value) {
  field.x[i] = value.x;
  field.y[i] = value.y;
  field.z[i] = value.z;
}

/// values[s] = values[order[s]], each item being `per_item` values.
template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order, std::size_t per_item,
             std::vector<T>& scratch) {
  scratch.resize(values.size());
  for (std::size_t s = 0; s < order.size(); ++s)
    for (std::size_t k = 0; k < per_item; ++k) scratch[s * per_item + k] = values[order[s] * per_item + k];
  values.swap(scratch);
}

}  // namespace

/// Pairs that may touch before the list is rebuilt, sorted by their first sphere, and what each remembers.
struct Engine::PairList {
  std::vector<std::uint32_t> start;          ///< of the pairs of each sphere of the share; one more than spheres
  std::vector<std::uint32_t> first, second;  ///< slots of the spheres; second: or number of the wall
  std::vector<std::uint8_t> image;           ///< see CellSearch
  std::vector<Row> memory;                   ///< tangential spring [m]; w: √m_eff [kg^½]
  std::vector<Row> rolling_memory;
  std::vector<std::uint32_t> last_step, first_step;    ///< of the newest contact, modulo 2^32
  std::vector<double> impact_speed;                    ///< of the newest contact; negative: none, or told already
  std::vector<double> normal_force, tangential_force;  ///< at the last step of advance()

  void clear() {
    start.assign(1, 0);
    first.clear();
    second.clear();
    image.clear();
  }
  void add(std::uint32_t i, std::uint32_t j, std::uint8_t with_image) {
    first.push_back(i);
    second.push_back(j);
    image.push_back(with_image);
  }
  void close_sphere() { start.push_back(static_cast<std::uint32_t>(second.size())); }
  void forget(std::uint32_t never) {
    const std::size_t pairs = second.size();
    memory.assign(pairs, {});
    rolling_memory.assign(pairs, {});
    last_step.assign(pairs, never);
    first_step.assign(pairs, never);
    impact_speed.assign(pairs, -1.0);
    normal_force.assign(pairs, 0.0);
    tangential_force.assign(pairs, 0.0);
  }
};

/// The second sphere of a pair, or the foot point on a wall.
struct Engine::SecondBody {
  Pack place, velocity, spin;
};

/// What a contact with a sphere of a later share does, until that share takes it [N], [N m].
struct Engine::OuterEffect {
  Pack force, torque_i, torque_j;
};

/// The spheres of one thread, their pairs and its workspace.
struct Engine::Share {
  std::size_t first = 0, last = 0;  ///< slots
  PairList inner, outer, wall;      ///< both spheres in the share; the second in a later one; walls
  std::vector<std::uint32_t> touching, outer_touching;
  std::vector<std::uint32_t> fresh;  ///< of the contacts computed last: those that have just begun
  std::vector<OuterEffect> outer_effect;
  std::vector<Row> foot;  ///< of each pair with a wall: the point of the wall; w = 0, no radius
  std::size_t outer_count = 0, outer_next = 0;
  double speed_squared = 0.0, speed_sum = 0.0, overlap = 0.0;
  Vec3 tracked_force;
  std::string failure;
  std::vector<Collision> collisions;
  ContactBatch batch{};
};

Engine::Engine(const Contact& contact, const ContactLawKernels& law, std::vector<Wall> walls,
               std::array<double, 3> period, int threads)
    : contact_(contact),
      walls_(std::move(walls)),
      period_(period),
      time_step_(contact.time_step),
      threads_(threads),
      periodic_(period[0] > 0.0 || period[1] > 0.0 || period[2] > 0.0),
      law_(law),
      rolling_(rolling_place(contact)),
      rolling_remembers_(contact.rolling_friction > 0.0 && contact.rolling_model == RollingModel::elastic_plastic) {
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
  for (int image = 0; image < 27; ++image)
    image_shift_[static_cast<std::size_t>(image)] = {(image % 3 - 1) * period[0], (image / 3 % 3 - 1) * period[1],
                                                     (image / 9 - 1) * period[2], 0.0};
  for (int t = 0; t < threads; ++t) shares_.push_back(std::make_unique<Share>());
}

Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;

template <class Integrator>
void Engine::choose_integrator() {
  integrator_rows_ = Integrator::rows;
  spring_phase_ = Integrator::spring_phase;
  move_ = &Engine::move<Integrator>;
  predict_ = &Engine::predict<Integrator>;
}

// --- spheres ---------------------------------------------------------------------------------------------------------

std::size_t Engine::add_particle(const std::array<double, 3>& centre, double radius, double density, int species) {
  finish_collisions();
  const Records records = contact_records();
  number_order();
  const std::size_t i = particles.add(centre, radius, density, species);
  resize_particle_arrays();
  if (list_valid_) list_anew(records);
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
  number_order();
  particles.remove(i);
  for (auto* field : {&external_force, &mean_solid_force_}) field->erase(i);
  const auto at = [i](auto& values, std::size_t per_sphere) {
    return values.begin() + static_cast<std::ptrdiff_t>(i * per_sphere);
  };
  contacts_.erase(at(contacts_, 1));
  contact_events_.erase(at(contact_events_, 1));
  integrator_.erase(at(integrator_, integrator_rows_),
                    at(integrator_, integrator_rows_) + static_cast<std::ptrdiff_t>(integrator_rows_));
  if (tracked_ == i) tracked_.reset();
  if (tracked_ && *tracked_ > i) --*tracked_;
  if (list_valid_) list_anew(records);
}

void Engine::resize_particle_arrays() {
  const std::size_t n = particles.size();
  for (auto* field : {&external_force, &mean_solid_force_}) field->resize(n);
  contacts_.resize(n, 0);
  contact_events_.resize(n, 0);
  integrator_.resize(n * integrator_rows_);
}

/// Lays the memory of the integrator out by the numbers of the spheres, for a change of their number.
void Engine::number_order() {
  if (list_valid_) permute(integrator_, slot_of_, integrator_rows_, row_scratch_);
}

bool Engine::moved_by_caller(std::size_t s) const {
  const Vec3 x = load(particles.position, order_[s]);
  return x.x != place_[s].x || x.y != place_[s].y || x.z != place_[s].z;
}

/// Takes the state from `particles`; where somebody has moved a sphere, the list is looked at before the next step.
void Engine::pack() {
  bool moved = false;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(|| : moved)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    fetch_ahead(i, place_, velocity_, spin_, constant_);
    const std::size_t s = slot_of_[i];
    const Vec3 x = load(particles.position, i), v = load(particles.velocity, i),
               w = load(particles.angular_velocity, i);
    const double inverse_mass = 1.0 / particles.inertial_mass(i);
    moved = moved || moved_by_caller(s);
    place_[s] = {x.x, x.y, x.z, particles.radius[i]};
    velocity_[s] = {v.x, v.y, v.z, inverse_mass};
    spin_[s] = {w.x, w.y, w.z, 1.0 / particles.inertia(i)};
    constant_[s].set(inverse_mass * load(external_force, i));
  }
  if (moved) travel_ = std::numeric_limits<double>::infinity();
}

/// Calls visit(first slot, second slot or wall, list, pair, at_wall) for all contacts of the last step.
template <class Visit>
void Engine::for_contacts(Visit visit) const {
  if (!list_valid_) return;
  for (const auto& share : shares_)
    for (const PairList* list : {&share->inner, &share->outer, &share->wall})
      for (std::uint32_t p = 0; p < list->second.size(); ++p)
        if (list->last_step[p] == static_cast<std::uint32_t>(steps_))
          visit(list->first[p], list->second[p], *list, p, list == &share->wall);
}

void Engine::unpack(std::int64_t steps) {
  last_advance_ = steps;
  const double inverse_time = 1.0 / (static_cast<double>(steps) * time_step_);
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    fetch_ahead(i, place_, velocity_, spin_, events_);
    const std::size_t s = slot_of_[i];
    const Vec3 v = velocity_[s].vector();
    const Vec3 gained = (particles.inertial_mass(i) * inverse_time) * (v - load(particles.velocity, i));
    store(mean_solid_force_, i, gained - load(external_force, i));
    store(particles.position, i, place_[s].vector());
    store(particles.velocity, i, v);
    store(particles.angular_velocity, i, spin_[s].vector());
    contact_events_[i] = events_[s];
    contacts_[i] = touched_[s];
  }
}

// --- the neighbour list ----------------------------------------------------------------------------------------------

double Engine::largest_displacement() const {
  double squared = 0.0;
  for (std::size_t s = 0; s < place_.size(); ++s) {
    const Vec3 moved = place_[s].vector() - origin_[s].vector();
    squared = std::max(squared, dot(moved, moved));
  }
  return std::sqrt(squared);
}

double Engine::choose_skin() const {
  double diameter = std::numeric_limits<double>::infinity(), speed = 0.0;
  for (std::size_t s = 0; s < place_.size(); ++s) {
    diameter = std::min(diameter, 2.0 * place_[s].w);
    speed = std::max(speed, norm(velocity_[s].vector()));
  }
  if (place_.empty()) return 0.0;
  if (list_valid_ && steps_ > list_step_)
    speed = largest_displacement() / (static_cast<double>(steps_ - list_step_) * time_step_);
  return std::clamp(std::sqrt(rebuild_cost * speed * time_step_ * diameter), least_skin * diameter,
                    largest_skin * diameter);
}

/// Takes the spheres from `particles`, whatever was before, and lists their pairs.
void Engine::list_anew(const Records& records, std::optional<double> skin) {
  const std::size_t n = particles.size();
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0U);
  slot_of_ = order_;
  for (auto* rows : {&place_, &velocity_, &spin_, &constant_}) rows->resize(n);
  for (auto* rows : {&force_, &torque_, &wall_force_row_, &contact_force_row_, &wall_lift_}) rows->assign(n, {});
  events_ = contact_events_;
  touched_.assign(n, 0);
  pack();
  list_valid_ = false;
  list_pairs(skin ? *skin : choose_skin());
  remember(records);
}

void Engine::rebuild() {
  finish_collisions();
  const Records records = contact_records();
  list_pairs(choose_skin());
  remember(records);
}

/// Sorts the spheres and finds their pairs, none of which remembers anything yet.
void Engine::list_pairs(double skin) {
  const std::size_t n = place_.size();
  if (periodic_)
    for (std::size_t s = 0; s < n; ++s) {
      Row& x = place_[s];
      if (period_[0] > 0.0) x.x -= period_[0] * std::nearbyint(x.x / period_[0]);
      if (period_[1] > 0.0) x.y -= period_[1] * std::nearbyint(x.y / period_[1]);
      if (period_[2] > 0.0) x.z -= period_[2] * std::nearbyint(x.z / period_[2]);
      store(particles.position, order_[s], x.vector());
    }
  const double reach = skin + (lubrication_ ? lubrication_->outer_gap() : 0.0);
  const std::vector<std::uint32_t>& sorted = search_.sort(place_, reach, period_);
  for (auto* rows : {&place_, &velocity_, &spin_, &constant_, &wall_lift_}) permute(*rows, sorted, 1, row_scratch_);
  permute(integrator_, sorted, integrator_rows_, row_scratch_);
  permute(order_, sorted, 1, number_scratch_);
  permute(events_, sorted, 1, count_scratch_);
  slot_of_.resize(n);
  for (std::size_t s = 0; s < n; ++s) slot_of_[order_[s]] = static_cast<std::uint32_t>(s);
  origin_ = place_;

#pragma omp parallel for num_threads(threads_) schedule(static, 1)
  for (std::size_t t = 0; t < shares_.size(); ++t) {
    Share& share = *shares_[t];
    share.first = n * t / shares_.size();
    share.last = n * (t + 1) / shares_.size();
    share.inner.clear();
    share.outer.clear();
    share.wall.clear();
    for (std::size_t i = share.first; i < share.last; ++i) {
      search_.for_pairs(place_, static_cast<std::uint32_t>(i), [&](std::uint32_t j, std::uint8_t image) {
        (j < share.last ? share.inner : share.outer).add(static_cast<std::uint32_t>(i), j, image);
      });
      for (std::uint32_t w = 0; w < walls_.size(); ++w)
        if (!walls_[w].clear_of(place_[i].vector(), place_[i].w + reach))
          share.wall.add(static_cast<std::uint32_t>(i), w, CellSearch::own_image);
      share.inner.close_sphere();
      share.outer.close_sphere();
      share.wall.close_sphere();
    }
    const auto never = static_cast<std::uint32_t>(steps_ - 1);
    for (PairList* list : {&share.inner, &share.outer, &share.wall}) {
      list->forget(never);
      for (std::size_t p = 0; p < list->second.size(); ++p) {
        const double inverse_mass = velocity_[list->first[p]].w;
        const double other = list == &share.wall ? 0.0 : velocity_[list->second[p]].w;
        list->memory[p].w = 1.0 / std::sqrt(inverse_mass + other);
      }
    }
    std::size_t most = share.wall.second.size();
    for (std::size_t i = 0; i + 1 < share.inner.start.size(); i += block_size)
      most = std::max<std::size_t>(
          most, share.inner.start[std::min(i + block_size, share.inner.start.size() - 1)] - share.inner.start[i]);
    share.touching.resize(most + 1);
    share.outer_touching.resize(share.outer.second.size() + 1);
    share.outer_effect.resize(share.outer.second.size());
    share.foot.assign(share.wall.second.size(), {});
  }
  skin_ = skin;
  travel_ = 0.0;
  margin_ = usable_skin * skin;
  list_step_ = steps_;
  list_valid_ = true;
  ++list_builds_;
}

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

void Engine::remember(const Records& records) {
  const auto touching = static_cast<std::uint32_t>(steps_);
  const auto keep = [&](std::size_t slot, std::uint32_t second, bool at_wall, const ContactRecord& record,
                        double sign) {
    std::size_t t = slot * shares_.size() / place_.size();
    while (slot >= shares_[t]->last) ++t;
    Share& share = *shares_[t];
    PairList& list = at_wall ? share.wall : second < share.last ? share.inner : share.outer;
    const std::size_t own = slot - share.first;
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

// --- a step ----------------------------------------------------------------------------------------------------------

/// Those of the pairs `first` to `last` that touch, written to `touching`, which must have room for one more than
/// there are; returns their number.
std::size_t Engine::find_touching(const PairList& list, std::uint32_t first, std::uint32_t last,
                                  std::uint32_t* touching) const {
  std::size_t count = 0;
  const auto find = [&](auto shift) {
    for (std::uint32_t p = first; p < last; ++p) {
      const Row &own = place_[list.first[p]], &other = place_[list.second[p]];
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

/// Computes the contacts `touching` of a list, a batch at a time. `second(p)` gives the rows of the second body of pair
/// p: place, velocity and spin; take(k, p, force, torque_i, torque_j) is told what contact k does, in order.
template <bool AtWall, class Second, class Take>
void Engine::compute(PairList& list, const std::uint32_t* touching, std::size_t count, Share& share, StepMode mode,
                     Second second, Take take) const {
  const ContactKernel kernel = law_.compute[rolling_][AtWall ? 1 : 0];
  const std::uint32_t step = now();
  ContactBatch& batch = share.batch;
  share.fresh.clear();
  std::size_t told = 0;
  for (std::size_t begin = 0; begin < count; begin += ContactBatch::capacity) {
    const std::size_t size = std::min(ContactBatch::capacity, count - begin);
    for (std::size_t k = 0; k < size; ++k) {
      const std::uint32_t p = touching[begin + k];
      if (list.last_step[p] != step - 1) {
        if (collect_collisions_ && !AtWall) finish_collision(share, list, p);
        list.memory[p].set({});
        if (rolling_remembers_) list.rolling_memory[p] = {};
        list.first_step[p] = step;
        share.fresh.push_back(static_cast<std::uint32_t>(begin + k));
      }
      list.last_step[p] = step;
    }
    for (std::size_t k = 0; k < size; k += 4) {
      // The last group is filled up by repeating its last contact.
      std::array<std::uint32_t, 4> p{};
      for (std::size_t lane = 0; lane < 4; ++lane) p[lane] = touching[begin + std::min(k + lane, size - 1)];
      const std::array<std::uint32_t, 4> i{list.first[p[0]], list.first[p[1]], list.first[p[2]], list.first[p[3]]};
      const auto from = [&](const std::vector<Row>& field, std::size_t lane) { return load(field[i[lane]]); };
      const std::array<SecondBody, 4> j{second(p[0]), second(p[1]), second(p[2]), second(p[3])};
      const auto memory = [&](const std::vector<Row>& field, std::size_t lane) { return load(field[p[lane]]); };
      batch.place_i.put(k, from(place_, 0), from(place_, 1), from(place_, 2), from(place_, 3));
      batch.place_j.put(k, j[0].place, j[1].place, j[2].place, j[3].place);
      batch.relative_velocity.put(k, from(velocity_, 0) - j[0].velocity, from(velocity_, 1) - j[1].velocity,
                                  from(velocity_, 2) - j[2].velocity, from(velocity_, 3) - j[3].velocity);
      batch.spin_i.put(k, from(spin_, 0), from(spin_, 1), from(spin_, 2), from(spin_, 3));
      batch.spin_j.put(k, j[0].spin, j[1].spin, j[2].spin, j[3].spin);
      batch.spring.put(k, memory(list.memory, 0), memory(list.memory, 1), memory(list.memory, 2),
                       memory(list.memory, 3));
      if (rolling_remembers_)
        batch.rolling_memory.put(k, memory(list.rolling_memory, 0), memory(list.rolling_memory, 1),
                                 memory(list.rolling_memory, 2), memory(list.rolling_memory, 3));
    }
    kernel(batch, (size + 3) / 4 * 4, contact_, spring_phase_);
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
    for (; !AtWall && told < share.fresh.size(); ++told) {
      const std::uint32_t k = share.fresh[told];
      list.impact_speed[touching[k]] = batch.torque_j.w[k - begin];
    }
    if (mode != StepMode::final) continue;
    for (std::size_t k = 0; k < size; ++k) {
      const std::uint32_t p = touching[begin + k];
      const double normal = batch.force.w[k];
      list.normal_force[p] = normal;
      list.tangential_force[p] = std::sqrt(std::max(0.0, dot(batch.force.at(k), batch.force.at(k)) - normal * normal));
      const double radius = AtWall ? batch.place_i.w[k] : std::min(batch.place_i.w[k], batch.place_j.w[k]);
      share.overlap = std::max(share.overlap, batch.torque_i.w[k] / radius);
    }
  }
}

template <class Take>
void Engine::compute_pairs(PairList& list, const std::uint32_t* touching, std::size_t count, Share& share,
                           StepMode mode, Take take) const {
  const auto second = [&](std::uint32_t p) {
    const std::uint32_t j = list.second[p];
    return SecondBody{load(place_[j]), load(velocity_[j]), load(spin_[j])};
  };
  const auto second_image = [&](std::uint32_t p) {
    SecondBody body = second(p);
    body.place += load(image_shift_[list.image[p]]);
    return body;
  };
  if (periodic_)
    compute<false>(list, touching, count, share, mode, second_image, take);
  else
    compute<false>(list, touching, count, share, mode, second, take);
}

/// Contacts with the walls: the first terms of the sums.
void Engine::compute_walls(Share& share, StepMode mode) {
  PairList& list = share.wall;
  std::size_t count = 0;
  for (std::uint32_t p = 0; p < list.second.size(); ++p) {
    const Row& own = place_[list.first[p]];
    const Wall& wall = walls_[list.second[p]];
    if (wall.clear_of(own.vector(), own.w)) continue;
    const Wall::Gap gap = wall.gap(own.vector());
    if (!(gap.distance > 0.0)) fail("has gone through a wall", list.first[p]);
    if (gap.distance >= own.w) continue;
    share.foot[p].set(own.vector() + gap.distance * gap.outward);
    share.touching[count++] = p;
  }
  compute<true>(
      list, share.touching.data(), count, share, mode,
      [&](std::uint32_t p) {
        return SecondBody{load(share.foot[p]), Pack{}, Pack{}};
      },
      [&](std::size_t, std::uint32_t p, Pack force, Pack torque, Pack) {
        const std::size_t i = list.first[p];
        store(force_[i], load(force_[i]) + force);
        store(torque_[i], load(torque_[i]) + torque);
        (list.second[p] == bottom_wall ? wall_lift_[i].x : wall_lift_[i].y) += force[2];
        if (mode == StepMode::final) store(wall_force_row_[i], load(wall_force_row_[i]) + force);
        if (i == tracked_slot_) share.tracked_force = share.tracked_force - Vec3{force[0], force[1], force[2]};
      });
}

void Engine::compute_outer(Share& share, StepMode mode) {
  PairList& list = share.outer;
  share.outer_count =
      find_touching(list, 0, static_cast<std::uint32_t>(list.second.size()), share.outer_touching.data());
  share.outer_next = 0;
  compute_pairs(list, share.outer_touching.data(), share.outer_count, share, mode,
                [&](std::size_t k, std::uint32_t, Pack force, Pack torque_i, Pack torque_j) {
                  share.outer_effect[k] = {force, torque_i, torque_j};
                });
}

/// Adds what the earlier shares' pairs do to the spheres of this one.
void Engine::receive(const Share& share) {
  for (const auto& other : shares_) {
    if (other.get() == &share) return;
    for (std::size_t k = 0; k < other->outer_count; ++k) {
      const std::uint32_t p = other->outer_touching[k], j = other->outer.second[p];
      if (j < share.first || j >= share.last) continue;
      store(force_[j], load(force_[j]) - other->outer_effect[k].force);
      store(torque_[j], load(torque_[j]) + other->outer_effect[k].torque_j);
      ++touched_[j];
      if (other->outer.first_step[p] == now()) ++events_[j];
    }
  }
}

void Engine::sweep(Share& share, StepMode mode) {
  if (mode == StepMode::final)
    for (std::size_t s = share.first; s < share.last; ++s) wall_force_row_[s] = {}, touched_[s] = 0;
  if (!share.wall.second.empty()) compute_walls(share, mode);
  receive(share);
  share.speed_squared = share.speed_sum = 0.0;
  PairList& list = share.inner;
  for (std::size_t first = share.first; first < share.last; first += block_size) {
    const std::size_t last = std::min(first + block_size, share.last);
    const std::size_t count =
        find_touching(list, list.start[first - share.first], list.start[last - share.first], share.touching.data());
    compute_pairs(list, share.touching.data(), count, share, mode,
                  [&](std::size_t, std::uint32_t p, Pack force, Pack torque_i, Pack torque_j) {
                    const std::uint32_t i = list.first[p], j = list.second[p];
                    store(force_[i], load(force_[i]) + force);
                    store(torque_[i], load(torque_[i]) + torque_i);
                    store(force_[j], load(force_[j]) - force);
                    store(torque_[j], load(torque_[j]) + torque_j);
                  });
    if (mode == StepMode::final)
      for (std::size_t k = 0; k < count; ++k) {
        ++touched_[list.first[share.touching[k]]];
        ++touched_[list.second[share.touching[k]]];
      }
    for (const std::uint32_t k : share.fresh) {
      ++events_[list.first[share.touching[k]]];
      ++events_[list.second[share.touching[k]]];
    }
    for (; share.outer_next < share.outer_count; ++share.outer_next) {
      const std::uint32_t p = share.outer_touching[share.outer_next], i = share.outer.first[p];
      if (i >= last) break;
      const OuterEffect& effect = share.outer_effect[share.outer_next];
      store(force_[i], load(force_[i]) + effect.force);
      store(torque_[i], load(torque_[i]) + effect.torque_i);
      ++touched_[i];
      if (share.outer.first_step[p] == now()) ++events_[i];
    }
    if (tracked_slot_ >= first && tracked_slot_ < last)
      share.tracked_force = share.tracked_force + force_[tracked_slot_].vector();
    (this->*move_)(share, first, last, mode);
  }
}

template <class Integrator>
void Engine::move(Share& share, std::size_t first, std::size_t last, StepMode mode) {
  double speed_squared = 0.0, speed_sum = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    if (mode == StepMode::final) {
      contact_force_row_[i] = force_[i];
      contact_force_row_[i].add(-1.0 * wall_force_row_[i].vector());
    }
    const Body body{place_[i], velocity_[i], spin_[i], integrator_.data() + i * Integrator::rows};
    const Vec3 constant = constant_[i].vector();
    const Acceleration contact{velocity_[i].w * force_[i].vector(), spin_[i].w * torque_[i].vector()};
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
  share.speed_squared = std::max(share.speed_squared, speed_squared);
  share.speed_sum += speed_sum;
}

template <class Integrator>
void Engine::predict(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i)
    Integrator::predict({place_[i], velocity_[i], spin_[i], integrator_.data() + i * Integrator::rows},
                        constant_[i].vector(), time_step_);
}

template <class Work>
void Engine::for_shares(Work work) {
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
  for (std::size_t t = 0; t < shares_.size(); ++t) {
    // An exception must not leave a parallel region.
    try {
      work(*shares_[t]);
    } catch (const EngineError& error) {
      shares_[t]->failure = error.what();
    }
  }
  for (auto& share : shares_)
    if (!share->failure.empty()) throw EngineError(std::exchange(share->failure, {}));
}

void Engine::advance(std::int64_t steps) {
  if (steps <= 0) return;
  if (particles.size() == 0) {
    steps_ += steps;
    return;
  }
  if (!list_valid_) {
    list_anew({});
    if (integrator_rows_ > 0) {
      // Integrators that remember accelerations need those of the start, when contacts may exist: a step in which
      // nothing moves, and no contact remembers that it was.
      for_shares([&](Share& share) { compute_outer(share, StepMode::start); });
      for_shares([&](Share& share) { sweep(share, StepMode::start); });
      number_order();
      list_anew({});
    }
  }
  pack();
  tracked_sum_ = {};
  for_shares([&](Share& share) {
    for (std::size_t s = share.first; s < share.last; ++s) wall_lift_[s] = {};
    (this->*predict_)(share.first, share.last);
  });
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
  if (travel_ > margin_) {
    // The bound adds the fastest sphere of each step; what has really been covered is less.
    const double covered = largest_displacement();
    travel_ = 0.0;
    margin_ = usable_skin * skin_ - covered;
    if (!(margin_ > 0.1 * skin_)) rebuild();
  } else if (steps_ - list_step_ >= longest_list_life) {
    rebuild();
  }
  tracked_slot_ = tracked_ ? slot_of_[*tracked_] : std::numeric_limits<std::size_t>::max();

  if (lubrication_) add_lubrication();
  for (auto& share : shares_) share->overlap = 0.0;
  if (threads_ > 1) for_shares([&](Share& share) { compute_outer(share, mode); });
  for_shares([&](Share& share) { sweep(share, mode); });

  double speed_squared = 0.0, speed_sum = 0.0;
  maximum_overlap_ = 0.0;
  for (auto& share : shares_) {
    speed_squared = std::max(speed_squared, share->speed_squared);
    speed_sum += share->speed_sum;
    maximum_overlap_ = std::max(maximum_overlap_, share->overlap);
    tracked_sum_ = tracked_sum_ + std::exchange(share->tracked_force, {});
  }
  if (!std::isfinite(speed_sum))
    for (std::size_t s = 0; s < velocity_.size(); ++s)
      if (!std::isfinite(dot(velocity_[s].vector(), velocity_[s].vector()))) fail("has no finite velocity any more", s);
  travel_ += time_step_ * std::sqrt(speed_squared);
  ++steps_;
}

/// Puts the lubrication forces among those of the coming step: sphere by sphere, and for each in the order of the
/// others, so that the sums do not depend on the shares.
void Engine::add_lubrication() {
  std::vector<std::pair<std::uint32_t, std::uint8_t>> others;
  for (const auto& share : shares_)
    for (std::size_t i = share->first; i < share->last; ++i) {
      const Row own = place_[i];
      const auto act = [&](Vec3 to_other, double touching_distance, double radius, Vec3 relative_velocity) {
        const double distance = norm(to_other);
        const Vec3 normal = (1.0 / distance) * to_other;
        return lubrication_->repulsion(distance - touching_distance, radius, dot(relative_velocity, normal)) * normal;
      };
      others.clear();
      for (const PairList* list : {&share->inner, &share->outer})
        for (std::uint32_t p = list->start[i - share->first]; p < list->start[i - share->first + 1]; ++p)
          others.emplace_back(list->second[p], list->image[p]);
      std::sort(others.begin(), others.end());
      for (const auto& [j, image] : others) {
        const Row other = place_[j];
        const Vec3 force = act(other.vector() + image_shift_[image].vector() - own.vector(), own.w + other.w,
                               reduced_radius(own.w, other.w), velocity_[i].vector() - velocity_[j].vector());
        force_[i].add(-1.0 * force);
        force_[j].add(force);
      }
      const PairList& walls = share->wall;
      for (std::uint32_t p = walls.start[i - share->first]; p < walls.start[i - share->first + 1]; ++p) {
        const std::uint32_t w = walls.second[p];
        const auto gap = walls_[w].gap(own.vector());
        const Vec3 force = act(gap.distance * gap.outward, own.w, own.w, velocity_[i].vector());
        force_[i].add(-1.0 * force);
        (w == bottom_wall ? wall_lift_[i].x : wall_lift_[i].y) -= force.z;
      }
    }
}

void Engine::fail(const char* what, std::size_t slot) const {
  const Row &x = place_[slot], &v = velocity_[slot];
  throw EngineError(fmt::format(
      "sphere {} {} at step {} (t = {:.6g} s of motion): centre ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.4g}, {:.4g}, "
      "{:.4g}) m/s; a smaller contact.time_step or a larger stiffness may be needed",
      order_[slot], what, steps_, static_cast<double>(steps_) * time_step_, x.x, x.y, x.z, v.x, v.y, v.z));
}

// --- what others ask for ---------------------------------------------------------------------------------------------

Engine::VerticalWallForces Engine::mean_vertical_wall_forces() const {
  VerticalWallForces sum;
  for (const std::uint32_t s : slot_of_) {
    sum.bottom += wall_lift_[s].x;
    sum.others += wall_lift_[s].y;
  }
  const auto steps = static_cast<double>(std::max<std::int64_t>(1, last_advance_));
  return {sum.bottom / steps, sum.others / steps};
}

bool Engine::touches_wall(std::size_t i, std::size_t wall) const {
  return walls_[wall].gap(load(particles.position, i)).distance < particles.radius[i];
}

std::size_t Engine::listed_pairs() const {
  std::size_t pairs = 0;
  for (const auto& share : shares_) pairs += share->inner.second.size() + share->outer.second.size();
  return pairs;
}

std::vector<Engine::TouchingPair> Engine::touching_pairs() const {
  std::vector<TouchingPair> pairs;
  for_contacts([&](std::size_t i, std::uint32_t j, const PairList& list, std::uint32_t p, bool at_wall) {
    pairs.push_back({order_[i], at_wall ? j : order_[j], at_wall, list.normal_force[p], list.tangential_force[p]});
  });
  return pairs;
}

double Engine::network_frequency_squared() const {
  std::vector<double> sum(place_.size(), 0.0);
  for_contacts([&](std::size_t i, std::uint32_t j, const PairList& list, std::uint32_t p, bool at_wall) {
    const Row& own = place_[i];
    if (at_wall) {
      sum[i] += law_.stiffness(contact_, true, own.w - walls_[j].gap(own.vector()).distance, own.w);
      return;
    }
    const Vec3 d = place_[j].vector() + image_shift_[list.image[p]].vector() - own.vector();
    const double radius = own.w * place_[j].w / (own.w + place_[j].w);
    const double stiffness = law_.stiffness(contact_, false, std::max(0.0, own.w + place_[j].w - norm(d)), radius);
    sum[i] += stiffness;
    sum[j] += stiffness;
  });
  double largest = 0.0;
  for (std::size_t s = 0; s < sum.size(); ++s) largest = std::max(largest, 2.0 * sum[s] * velocity_[s].w);
  return largest;
}

/// Keeps the newest contact of a pair, which has ended, unless that is done.
void Engine::finish_collision(Share& share, PairList& list, std::uint32_t p) const {
  if (list.impact_speed[p] < 0.0) return;
  const std::uint32_t a = order_[list.first[p]], b = order_[list.second[p]];
  const auto ago = static_cast<std::uint32_t>(steps_) - list.last_step[p];
  share.collisions.push_back({std::min(a, b), std::max(a, b), steps_ - static_cast<std::int64_t>(ago),
                              list.last_step[p] - list.first_step[p] + 1, list.impact_speed[p]});
  list.impact_speed[p] = -1.0;
}

/// All collisions that have ended, by the numbers that the spheres have now.
void Engine::finish_collisions() {
  if (!collect_collisions_ || !list_valid_) return;
  for (auto& share : shares_)
    for (PairList* list : {&share->inner, &share->outer})
      for (std::uint32_t p = 0; p < list->second.size(); ++p)
        if (list->last_step[p] != static_cast<std::uint32_t>(steps_)) finish_collision(*share, *list, p);
}

void Engine::collect_collisions(bool on) {
  collect_collisions_ = true;
  take_collisions();  // what has ended before is nobody's business
  collect_collisions_ = on;
}

std::vector<Collision> Engine::take_collisions() {
  std::vector<Collision> all;
  finish_collisions();
  for (auto& share : shares_) {
    all.insert(all.end(), share->collisions.begin(), share->collisions.end());
    share->collisions.clear();
  }
  std::sort(all.begin(), all.end(), [](const Collision& a, const Collision& b) {
    return std::tuple(a.end_step, a.first, a.second) < std::tuple(b.end_step, b.first, b.second);
  });
  return all;
}

// --- checkpoints -----------------------------------------------------------------------------------------------------

Engine::Memory Engine::memory() const {
  Memory memory;
  Records records = contact_records();
  memory.contacts = std::move(records.spheres);
  memory.wall_contacts = std::move(records.walls);
  memory.contact_events = contact_events_;
  memory.mean_solid_force = mean_solid_force_;
  memory.list_position.resize(origin_.size());
  for (std::size_t s = 0; s < origin_.size(); ++s) store(memory.list_position, order_[s], origin_[s].vector());
  memory.skin = skin_;
  memory.travel = travel_;
  for (std::size_t s = 0; list_valid_ && s < place_.size(); ++s)
    if (moved_by_caller(s)) memory.travel = std::numeric_limits<double>::infinity();
  memory.margin = margin_;
  memory.list_step = list_step_;
  memory.steps = steps_;
  for (std::size_t i = 0; i < slot_of_.size(); ++i)
    for (std::size_t k = 0; k < integrator_rows_; ++k) {
      const Row& row = integrator_[slot_of_[i] * integrator_rows_ + k];
      memory.integrator.insert(memory.integrator.end(), {row.x, row.y, row.z});
    }
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
  for (std::size_t k = 0; k < integrator_.size(); ++k)
    integrator_[k].set({memory.integrator[3 * k], memory.integrator[3 * k + 1], memory.integrator[3 * k + 2]});
  // The order of all sums comes from the positions at which the list was built.
  const VectorField now_at = std::exchange(particles.position, memory.list_position);
  list_anew({memory.contacts, memory.wall_contacts}, memory.skin);
  particles.position = now_at;
  pack();
  list_step_ = memory.list_step;
  travel_ = memory.travel;
  margin_ = memory.margin;
}

}  // namespace slfb::dem
