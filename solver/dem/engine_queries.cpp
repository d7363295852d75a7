// What others ask the engine for: forces, contacts, collisions.
#include <algorithm>
#include <tuple>
#include <utility>

#include "solver/dem/engine_internals.hpp"

namespace slfb::dem {

Engine::VerticalWallForces Engine::mean_vertical_wall_forces() const {
  VerticalWallForces sum;
  for (const std::uint32_t s : slot_of_) {
    sum.bottom += vertical_wall_force_[s].x;
    sum.others += vertical_wall_force_[s].y;
  }
  const auto steps = static_cast<double>(std::max<std::int64_t>(1, last_advance_));
  if (integrate_wall_forces_ != nullptr) {
    const double per_time = 1.0 / (steps * time_step_);
    return {per_time * wall_impulse_[0].velocity.z, per_time * wall_impulse_[1].velocity.z};
  }
  return {sum.bottom / steps, sum.others / steps};
}

bool Engine::touches_wall(std::size_t i, std::size_t wall) const {
  return walls_[wall].gap(particles.position.vector(i)).distance < particles.radius[i];
}

std::size_t Engine::listed_pairs() const {
  std::size_t pairs = 0;
  for (const auto& partition : partitions_) pairs += partition->inner.second.size() + partition->outer.second.size();
  return pairs;
}

std::optional<Engine::DeepContact> Engine::take_deepest_contact() {
  DeepContact deepest;
  for (auto& partition : partitions_) {
    const DeepContact own = std::exchange(partition->deepest, {});
    if (own.share > deepest.share) deepest = own;
  }
  return deepest.share > 0.0 ? std::optional(deepest) : std::nullopt;
}

std::vector<Engine::TouchingPair> Engine::touching_pairs() const {
  std::vector<TouchingPair> pairs;
  for_contacts([&](std::size_t i, std::uint32_t j, const PairList& list, std::uint32_t p, bool at_wall) {
    pairs.push_back({order_[i], at_wall ? j : order_[j], at_wall, list.normal_force[p], list.tangential_force[p]});
  });
  return pairs;
}

double Engine::network_frequency_squared() const {
  std::vector<double> sum(position_.size(), 0.0);
  for_contacts([&](std::size_t i, std::uint32_t j, const PairList& list, std::uint32_t p, bool at_wall) {
    const Vec4& own = position_[i];
    if (at_wall) {
      sum[i] += law_.stiffness(wall_contact_, true, own.w - walls_[j].gap(own.vector()).distance, own.w);
      return;
    }
    const Vec3 d = position_[j].vector() + image_shift_[list.image[p]].vector() - own.vector();
    const double radius = own.w * position_[j].w / (own.w + position_[j].w);
    const double stiffness = law_.stiffness(contact_, false, std::max(0.0, own.w + position_[j].w - norm(d)), radius);
    sum[i] += stiffness;
    sum[j] += stiffness;
  });
  double largest = 0.0;
  for (std::size_t s = 0; s < sum.size(); ++s) largest = std::max(largest, 2.0 * sum[s] * velocity_[s].w);
  return largest;
}

/// Keeps the newest contact of a pair, which has ended, unless that is done.
void Engine::finish_collision(ThreadPartition& partition, PairList& list, std::uint32_t p) const {
  if (list.impact_speed[p] < 0.0) return;
  const std::uint32_t a = order_[list.first[p]], b = order_[list.second[p]];
  const auto ago = static_cast<std::uint32_t>(steps_) - list.last_step[p];
  partition.collisions.push_back({std::min(a, b), std::max(a, b), steps_ - static_cast<std::int64_t>(ago),
                                  list.last_step[p] - list.first_step[p] + 1, list.impact_speed[p]});
  list.impact_speed[p] = -1.0;
}

/// All collisions that have ended, by the numbers that the spheres have now.
void Engine::finish_collisions() {
  if (!collect_collisions_ || !list_valid_) return;
  for (auto& partition : partitions_)
    for (PairList* list : {&partition->inner, &partition->outer})
      for (std::uint32_t p = 0; p < list->second.size(); ++p)
        if (list->last_step[p] != static_cast<std::uint32_t>(steps_)) finish_collision(*partition, *list, p);
}

void Engine::collect_collisions(bool on) {
  collect_collisions_ = true;
  take_collisions();  // those that ended before recording began are dropped
  collect_collisions_ = on;
}

std::vector<Collision> Engine::take_collisions() {
  std::vector<Collision> all;
  finish_collisions();
  for (auto& partition : partitions_) {
    all.insert(all.end(), partition->collisions.begin(), partition->collisions.end());
    partition->collisions.clear();
  }
  std::sort(all.begin(), all.end(), [](const Collision& a, const Collision& b) {
    return std::tuple(a.end_step, a.first, a.second) < std::tuple(b.end_step, b.first, b.second);
  });
  return all;
}

}  // namespace slfb::dem
