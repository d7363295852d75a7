#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "solver/dem/contact_batch.hpp"
#include "solver/dem/engine.hpp"

/// Structs that the four source files of the engine share; for no other file.
namespace slfb::dem {

/// Spheres whose contacts are computed together: some hundred contacts, which fit the first cache.
constexpr std::size_t block_size = 32;

/// values[s] = values[order[s]], each item being `per_item` values.
template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order, std::size_t per_item,
             std::vector<T>& scratch) {
  scratch.resize(values.size());
  for (std::size_t s = 0; s < order.size(); ++s)
    for (std::size_t k = 0; k < per_item; ++k) scratch[s * per_item + k] = values[order[s] * per_item + k];
  values.swap(scratch);
}

/// Pairs that may touch before the list is rebuilt, sorted by their first sphere, and what each remembers.
struct PairList {
  std::vector<std::uint32_t> start;          ///< of the pairs of each sphere of the partition; one more than spheres
  std::vector<std::uint32_t> first, second;  ///< slots of the spheres; second: or number of the wall
  std::vector<std::uint8_t> image;           ///< see CellSearch
  std::vector<Vec4> memory;                  ///< tangential spring [m]; w: √m_eff [kg^½]
  std::vector<Vec4> rolling_memory;
  std::vector<std::uint32_t> last_step, first_step;  ///< of the newest contact, modulo 2^32
  std::vector<double> impact_speed;  ///< of the newest contact; negative: none, or recorded as a collision
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
  /// No pair has touched yet: `never` is the number of no step that can be asked for.
  void reset_memory(std::uint32_t never) {
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

/// Force and torques of a contact with a sphere of a later partition, until that partition adds them [N], [N m].
struct OuterEffect {
  Pack force, torque_i, torque_j;
};

/// The spheres of one thread, their pairs and its workspace.
struct ThreadPartition {
  std::size_t first = 0, last = 0;  ///< slots
  PairList inner, outer, wall;      ///< both spheres in the partition; the second in a later one; walls
  std::vector<std::uint32_t> touching, outer_touching;
  std::vector<std::uint32_t> new_contacts;  ///< of the contacts computed last: those that have just begun
  std::vector<OuterEffect> outer_effects;
  std::vector<Vec4> wall_point;  ///< of each pair with a wall: the point of the wall; w = 0, no radius
  std::size_t outer_count = 0, outer_next = 0;
  double speed_squared = 0.0, speed_sum = 0.0, overlap = 0.0;
  Engine::DeepContact deepest;  ///< since it was last asked for; share 0: none
  Vec3 tracked_force;
  std::string failure;
  std::vector<Collision> collisions;
  ContactBatch batch{};
};

/// Calls visit(first slot, second slot or wall, list, pair, at_wall) for all contacts of the last step.
template <class Visit>
void Engine::for_contacts(Visit visit) const {
  if (!list_valid_) return;
  for (const auto& partition : partitions_)
    for (const PairList* list : {&partition->inner, &partition->outer, &partition->wall})
      for (std::uint32_t p = 0; p < list->second.size(); ++p)
        if (list->last_step[p] == static_cast<std::uint32_t>(steps_))
          visit(list->first[p], list->second[p], *list, p, list == &partition->wall);
}

}  // namespace slfb::dem
