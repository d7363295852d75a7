#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/dem/particles.hpp"

namespace slfb::dem {

/// Verlet list: for each sphere i the spheres j > i closer than r_i + r_j + skin, in ascending order, and for each
/// sphere j the pairs in which it is the second member. The fixed order makes every sum independent of threads.
class NeighbourList {
 public:
  /// `period`: extent of a periodic box in x, y and z, 0 where the domain is not periodic [m].
  void build(const Particles& particles, double skin, const std::array<double, 3>& period, int threads);

  [[nodiscard]] std::size_t pairs() const { return second_.size(); }
  [[nodiscard]] const std::vector<std::uint32_t>& start() const { return start_; }
  [[nodiscard]] const std::vector<std::uint32_t>& second() const { return second_; }
  [[nodiscard]] const std::vector<std::uint32_t>& reverse_start() const { return reverse_start_; }
  [[nodiscard]] const std::vector<std::uint32_t>& reverse_pair() const { return reverse_pair_; }

  /// True once a sphere has moved so far that a contact could be missed.
  [[nodiscard]] bool outdated(double largest_displacement_squared) const {
    return largest_displacement_squared > 0.25 * skin_ * skin_;
  }
  [[nodiscard]] const VectorField& origin() const { return origin_; }

 private:
  double skin_ = 0.0;
  VectorField origin_;  ///< positions when the list was built
  std::vector<std::uint32_t> start_, second_, reverse_start_, reverse_pair_;
  std::vector<std::uint32_t> cell_start_, cell_member_, cell_of_;
};

}  // namespace slfb::dem
