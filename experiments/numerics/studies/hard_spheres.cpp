#include "experiments/numerics/studies/hard_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace slfb::void_fraction_study {
namespace {

using Vector = std::array<double, 3>;

/// The cube in boxes of a little more than one diameter, to find who is near.
class Boxes {
 public:
  Boxes(double side, std::size_t spheres) : side_(side), across_(static_cast<int>(side / 1.1)), box_(spheres) {
    members_.resize(static_cast<std::size_t>(across_ * across_ * across_));
  }

  void place(std::size_t i, const Vector& x) {
    const std::size_t box = index(coordinate(x[0]), coordinate(x[1]), coordinate(x[2]));
    std::erase(members_[box_[i]], i);
    members_[box].push_back(i);
    box_[i] = box;
  }

  /// Calls `visit` with every sphere of the 27 boxes about a place.
  template <class Visit>
  void near(const Vector& x, Visit visit) const {
    for (int n = 0; n < 27; ++n)
      for (const std::size_t other : members_[index(coordinate(x[0]) + n / 9 - 1, coordinate(x[1]) + n / 3 % 3 - 1,
                                                    coordinate(x[2]) + n % 3 - 1)])
        visit(other);
  }

 private:
  [[nodiscard]] int coordinate(double x) const { return static_cast<int>(x / side_ * across_); }
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    const auto wrapped = [&](int n) { return (n + across_) % across_; };
    return static_cast<std::size_t>((wrapped(i) * across_ + wrapped(j)) * across_ + wrapped(k));
  }

  double side_;
  int across_;
  std::vector<std::vector<std::size_t>> members_;
  std::vector<std::size_t> box_;
};

}  // namespace

Assembly hard_spheres(int count, double solids, unsigned seed) {
  Assembly assembly{std::cbrt(count * std::numbers::pi / 6.0 / solids), {}};
  const double side = assembly.side;
  std::mt19937_64 generator(seed);
  // Integers scaled by hand: the library's distributions differ between machines.
  const auto random = [&] { return side * static_cast<double>(generator() >> 11) * 0x1p-53; };
  for (int i = 0; i < count; ++i) assembly.centres.push_back({random(), random(), random()});
  Boxes boxes(side, assembly.centres.size());
  for (std::size_t i = 0; i < assembly.centres.size(); ++i) boxes.place(i, assembly.centres[i]);

  const auto wrapped = [&](double x) { return x - side * std::floor(x / side); };
  constexpr double wanted = 1.01;  // pushed a little further than contact, so that the pushing comes to an end
  std::vector<std::size_t> neighbours;
  for (bool overlapping = true; overlapping;) {
    overlapping = false;
    for (std::size_t i = 0; i < assembly.centres.size(); ++i) {
      neighbours.clear();
      boxes.near(assembly.centres[i], [&](std::size_t j) { neighbours.push_back(j); });
      for (const std::size_t j : neighbours) {
        if (j == i) continue;
        Vector &x = assembly.centres[i], &y = assembly.centres[j], apart{};
        for (std::size_t a = 0; a < 3; ++a) apart[a] = x[a] - y[a] - side * std::rint((x[a] - y[a]) / side);
        const double distance = std::sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
        if (distance >= wanted) continue;
        overlapping = overlapping || distance < 1.0;
        for (std::size_t a = 0; a < 3; ++a) {
          const double push = 0.5 * (wanted / distance - 1.0) * apart[a];
          x[a] = wrapped(x[a] + push);
          y[a] = wrapped(y[a] - push);
        }
        boxes.place(i, x);
        boxes.place(j, y);
      }
    }
  }
  return assembly;
}

}  // namespace slfb::void_fraction_study
