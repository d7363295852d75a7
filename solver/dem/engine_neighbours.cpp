// The neighbour list: when it is built, in which order, and who computes which pairs.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/dem/engine_internals.hpp"

namespace slfb::dem {
namespace {

/// The skin balances the pairs that a step tests though they do not touch, about 10 skin/d per sphere, against
/// rebuilding the list, which costs as much as testing this many pairs times two.
constexpr double rebuild_cost = 15.0;
constexpr double least_skin = 0.02, largest_skin = 0.4;  ///< over the smallest diameter

/// Each of two spheres may come nearer by half the skin; a little is kept for what the bound of the travel leaves out.
constexpr double usable_skin = 0.49;

/// Steps after which the list is rebuilt even if nothing has moved far: the skin of a bed at rest can then shrink.
constexpr std::int64_t longest_list_life = 1000;

}  // namespace

double Engine::largest_displacement() const {
  double squared = 0.0;
  for (std::size_t s = 0; s < position_.size(); ++s) {
    const Vec3 moved = position_[s].vector() - list_position_[s].vector();
    squared = std::max(squared, dot(moved, moved));
  }
  return std::sqrt(squared);
}

double Engine::choose_skin() const {
  double diameter = std::numeric_limits<double>::infinity(), speed = 0.0;
  for (std::size_t s = 0; s < position_.size(); ++s) {
    diameter = std::min(diameter, 2.0 * position_[s].w);
    speed = std::max(speed, norm(velocity_[s].vector()));
  }
  if (position_.empty()) return 0.0;
  if (list_valid_ && steps_ > list_step_)
    speed = largest_displacement() / (static_cast<double>(steps_ - list_step_) * time_step_);
  return std::clamp(std::sqrt(rebuild_cost * speed * time_step_ * diameter), least_skin * diameter,
                    largest_skin * diameter);
}

/// Takes the spheres from `particles`, whatever was known of them before, and lists their pairs.
void Engine::rebuild_from_particles(const Records& records, std::optional<double> skin) {
  const std::size_t n = particles.size();
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0U);
  slot_of_ = order_;
  for (auto* vectors : {&position_, &velocity_, &angular_velocity_, &external_acceleration_}) vectors->resize(n);
  for (auto* vectors : {&force_, &torque_, &wall_force_, &contact_force_, &vertical_wall_force_})
    vectors->assign(n, {});
  events_ = contact_events_;
  touched_.assign(n, 0);
  pack();
  list_valid_ = false;
  list_pairs(skin ? *skin : choose_skin());
  restore_contacts(records);
}

/// Before a step: whether a sphere can have come further than the skin allows.
void Engine::rebuild_when_needed() {
  if (travel_ > margin_) {
    // The bound adds the fastest sphere of each step; the largest real displacement is less.
    const double covered = largest_displacement();
    travel_ = 0.0;
    margin_ = usable_skin * skin_ - covered;
    if (!(margin_ > 0.1 * skin_)) rebuild();
  } else if (steps_ - list_step_ >= longest_list_life) {
    rebuild();
  }
}

void Engine::rebuild() {
  finish_collisions();
  const Records records = contact_records();
  list_pairs(choose_skin());
  restore_contacts(records);
}

/// Sorts the spheres and finds their pairs, none of which remembers anything yet.
void Engine::list_pairs(double skin) {
  const std::size_t n = position_.size();
  if (periodic_)
    for (std::size_t s = 0; s < n; ++s) {
      Vec4& x = position_[s];
      if (period_[0] > 0.0) x.x -= period_[0] * std::nearbyint(x.x / period_[0]);
      if (period_[1] > 0.0) x.y -= period_[1] * std::nearbyint(x.y / period_[1]);
      if (period_[2] > 0.0) x.z -= period_[2] * std::nearbyint(x.z / period_[2]);
      particles.position.set(order_[s], x.vector());
    }
  const double reach = skin + (lubrication_ ? lubrication_->outer_gap() : 0.0);
  const std::vector<std::uint32_t>& sorted = search_.sort(position_, reach, period_);
  for (auto* vectors : {&position_, &velocity_, &angular_velocity_, &external_acceleration_, &vertical_wall_force_})
    permute(*vectors, sorted, 1, vector_scratch_);
  permute(integrator_memory_, sorted, integrator_size_, vector_scratch_);
  permute(order_, sorted, 1, number_scratch_);
  permute(events_, sorted, 1, count_scratch_);
  slot_of_.resize(n);
  for (std::size_t s = 0; s < n; ++s) slot_of_[order_[s]] = static_cast<std::uint32_t>(s);
  list_position_ = position_;

#pragma omp parallel for num_threads(threads_) schedule(static, 1)
  for (std::size_t t = 0; t < partitions_.size(); ++t) {
    ThreadPartition& partition = *partitions_[t];
    partition.first = n * t / partitions_.size();
    partition.last = n * (t + 1) / partitions_.size();
    partition.inner.clear();
    partition.outer.clear();
    partition.wall.clear();
    for (std::size_t i = partition.first; i < partition.last; ++i) {
      search_.for_pairs(position_, static_cast<std::uint32_t>(i), [&](std::uint32_t j, std::uint8_t image) {
        (j < partition.last ? partition.inner : partition.outer).add(static_cast<std::uint32_t>(i), j, image);
      });
      for (std::uint32_t w = 0; w < walls_.size(); ++w)
        if (!walls_[w].clear_of(position_[i].vector(), position_[i].w + reach))
          partition.wall.add(static_cast<std::uint32_t>(i), w, CellSearch::own_image);
      partition.inner.close_sphere();
      partition.outer.close_sphere();
      partition.wall.close_sphere();
    }
    const auto never = static_cast<std::uint32_t>(steps_ - 1);
    for (PairList* list : {&partition.inner, &partition.outer, &partition.wall}) {
      list->reset_memory(never);
      for (std::size_t p = 0; p < list->second.size(); ++p) {
        const double inverse_mass = velocity_[list->first[p]].w;
        const double other = list == &partition.wall ? 0.0 : velocity_[list->second[p]].w;
        list->memory[p].w = 1.0 / std::sqrt(inverse_mass + other);
      }
    }
    std::size_t most = partition.wall.second.size();
    for (std::size_t i = 0; i + 1 < partition.inner.start.size(); i += block_size)
      most = std::max<std::size_t>(
          most,
          partition.inner.start[std::min(i + block_size, partition.inner.start.size() - 1)] - partition.inner.start[i]);
    partition.touching.resize(most + 1);
    partition.outer_touching.resize(partition.outer.second.size() + 1);
    partition.outer_effects.resize(partition.outer.second.size());
    partition.wall_point.assign(partition.wall.second.size(), {});
  }
  skin_ = skin;
  travel_ = 0.0;
  margin_ = usable_skin * skin;
  list_step_ = steps_;
  list_valid_ = true;
  ++list_builds_;
}

}  // namespace slfb::dem
