#include "solver/dem/neighbour_list.hpp"

#include <algorithm>
#include <cmath>

namespace slfb::dem {

void NeighbourList::build(const Particles& particles, double skin, const std::array<double, 3>& period, int threads) {
  const std::size_t n = particles.size();
  skin_ = skin;
  origin_ = particles.position;
  start_.assign(n + 1, 0);
  second_.clear();
  reverse_start_.assign(n + 1, 0);
  reverse_pair_.clear();
  if (n == 0) return;

  const double largest_radius = *std::max_element(particles.radius.begin(), particles.radius.end());
  const double reach = 2.0 * largest_radius + skin;
  const std::array<const std::vector<double>*, 3> coordinate{&origin_.x, &origin_.y, &origin_.z};
  std::array<double, 3> lower{}, inverse{};
  std::array<int, 3> cells{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [least, most] = std::minmax_element(coordinate[a]->begin(), coordinate[a]->end());
    const bool periodic = period[a] > 0.0;
    lower[a] = periodic ? -0.5 * period[a] : *least;
    const double extent = periodic ? period[a] : *most - *least;
    // Below three cells a periodic direction would visit a neighbour twice: use one cell there.
    cells[a] = std::clamp(static_cast<int>(extent / reach), 1, 1024);
    if (periodic && cells[a] < 3) cells[a] = 1;
    inverse[a] = extent > 0.0 ? cells[a] / extent : 0.0;
  }
  const auto cell_coordinate = [&](std::size_t a, double value) {
    return std::clamp(static_cast<int>((value - lower[a]) * inverse[a]), 0, cells[a] - 1);
  };
  const std::size_t cell_count =
      static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cells[2]);
  const auto cell_index = [&](int cx, int cy, int cz) {
    return static_cast<std::uint32_t>((cz * cells[1] + cy) * cells[0] + cx);
  };

  cell_of_.resize(n);
  cell_start_.assign(cell_count + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    cell_of_[i] = cell_index(cell_coordinate(0, origin_.x[i]), cell_coordinate(1, origin_.y[i]),
                             cell_coordinate(2, origin_.z[i]));
    ++cell_start_[cell_of_[i] + 1];
  }
  for (std::size_t c = 0; c < cell_count; ++c) cell_start_[c + 1] += cell_start_[c];
  cell_member_.resize(n);
  std::vector<std::uint32_t> next(cell_start_.begin(), cell_start_.end() - 1);
  for (std::size_t i = 0; i < n; ++i) cell_member_[next[cell_of_[i]]++] = static_cast<std::uint32_t>(i);

  // Copied in the order of the cells: the search then runs over contiguous memory, a row of three cells at a time.
  struct Entry {
    double x, y, z, radius;
  };
  std::vector<Entry> entry(n);
  for (std::size_t m = 0; m < n; ++m) {
    const std::uint32_t j = cell_member_[m];
    entry[m] = {origin_.x[j], origin_.y[j], origin_.z[j], particles.radius[j]};
  }

  std::vector<std::vector<std::uint32_t>> found(static_cast<std::size_t>(threads));
#pragma omp parallel for num_threads(threads) schedule(static, 1)
  for (int t = 0; t < threads; ++t) {
    const std::size_t first = n * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
    const std::size_t last = n * (static_cast<std::size_t>(t) + 1) / static_cast<std::size_t>(threads);
    auto& list = found[static_cast<std::size_t>(t)];
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t begin = list.size();
      const std::array<double, 3> xi = origin_.at(i);
      const double own_reach = particles.radius[i] + skin;
      const auto search = [&](std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t m = from; m < to; ++m) {
          const Entry& other = entry[m];
          double dx = other.x - xi[0], dy = other.y - xi[1], dz = other.z - xi[2];
          if (period[0] > 0.0) dx -= period[0] * std::nearbyint(dx / period[0]);
          if (period[1] > 0.0) dy -= period[1] * std::nearbyint(dy / period[1]);
          if (period[2] > 0.0) dz -= period[2] * std::nearbyint(dz / period[2]);
          const double limit = own_reach + other.radius;
          if (dx * dx + dy * dy + dz * dz < limit * limit && cell_member_[m] > i) list.push_back(cell_member_[m]);
        }
      };
      std::array<std::array<int, 3>, 3> around{};
      std::array<int, 3> count{};
      for (std::size_t a = 0; a < 3; ++a) {
        const int c = cell_coordinate(a, xi[a]);
        for (int shift = -1; shift <= 1; ++shift) {
          int k = c + shift;
          if (period[a] > 0.0 && cells[a] > 1) k = (k + cells[a]) % cells[a];
          if (k < 0 || k >= cells[a]) continue;
          around[a][static_cast<std::size_t>(count[a]++)] = k;
        }
      }
      for (int kz = 0; kz < count[2]; ++kz)
        for (int ky = 0; ky < count[1]; ++ky) {
          const int cy = around[1][static_cast<std::size_t>(ky)], cz = around[2][static_cast<std::size_t>(kz)];
          if (period[0] == 0.0) {
            search(cell_start_[cell_index(around[0][0], cy, cz)],
                   cell_start_[cell_index(around[0][static_cast<std::size_t>(count[0] - 1)], cy, cz) + 1]);
            continue;
          }
          for (int kx = 0; kx < count[0]; ++kx) {
            const std::uint32_t cell = cell_index(around[0][static_cast<std::size_t>(kx)], cy, cz);
            search(cell_start_[cell], cell_start_[cell + 1]);
          }
        }
      std::sort(list.begin() + static_cast<std::ptrdiff_t>(begin), list.end());
      start_[i + 1] = static_cast<std::uint32_t>(list.size() - begin);
    }
  }
  for (std::size_t i = 0; i < n; ++i) start_[i + 1] += start_[i];
  for (const auto& list : found) second_.insert(second_.end(), list.begin(), list.end());

  for (const std::uint32_t j : second_) ++reverse_start_[j + 1];
  for (std::size_t j = 0; j < n; ++j) reverse_start_[j + 1] += reverse_start_[j];
  reverse_pair_.resize(second_.size());
  next.assign(reverse_start_.begin(), reverse_start_.end() - 1);
  for (std::uint32_t p = 0; p < second_.size(); ++p) reverse_pair_[next[second_[p]]++] = p;
}

}  // namespace slfb::dem
