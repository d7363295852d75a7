#include "solver/dem/granular_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/support/vec3.hpp"

namespace slfb::dem {

double fluctuating_energy(const Particles& particles, std::optional<std::size_t> excluded) {
  return local_fluctuating_energy(particles, {0.0, 0.0, 0.0}, excluded);
}

double local_fluctuating_energy(const Particles& particles, const std::array<double, 3>& box,
                                std::optional<std::size_t> excluded) {
  struct Member {
    std::array<std::int64_t, 3> box;
    Vec3 velocity;
  };
  const auto number = [](double coordinate, double edge) {
    return edge > 0.0 ? static_cast<std::int64_t>(std::floor(coordinate / edge)) : 0;
  };
  std::vector<Member> members;
  members.reserve(particles.size());
  const VectorField &x = particles.position, &u = particles.velocity;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (i != excluded)
      members.push_back(
          {{number(x.x[i], box[0]), number(x.y[i], box[1]), number(x.z[i], box[2])}, {u.x[i], u.y[i], u.z[i]}});
  std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.box < b.box; });

  double squares = 0.0;
  std::ptrdiff_t freedoms = 0;
  for (auto first = members.begin(); first != members.end();) {
    const auto last = std::find_if(first, members.end(), [&](const Member& m) { return m.box != first->box; });
    Vec3 sum;
    for (auto m = first; m != last; ++m) sum = sum + m->velocity;
    const Vec3 mean = (1.0 / static_cast<double>(last - first)) * sum;
    for (auto m = first; m != last; ++m) squares += dot(m->velocity - mean, m->velocity - mean);
    freedoms += last - first - 1;
    first = last;
  }
  return freedoms == 0 ? 0.0 : 0.5 * squares / static_cast<double>(freedoms);
}

}  // namespace slfb::dem
