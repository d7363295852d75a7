#include "solver/dem/packing.hpp"

#include <Random123/philox.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "solver/scene/scene_problems.hpp"

namespace slfb::dem {
namespace {

/// Uniform number in [0, 1) from (seed, item, component), the same on every machine.
double uniform(std::uint64_t seed, std::uint64_t item, std::uint64_t component) {
  const r123::Philox4x64::ctr_type counter{{item, component, 0, 0}};
  const r123::Philox4x64::key_type key{{seed, 0}};
  return static_cast<double>(r123::Philox4x64()(counter, key)[0] >> 11) * 0x1.0p-53;
}

/// Species of each sphere, in random order.
std::vector<int> shuffled_species(const Scene& scene) {
  std::vector<int> order;
  for (std::size_t s = 0; s < scene.species.size(); ++s)
    order.insert(order.end(), static_cast<std::size_t>(scene.species[s].count), static_cast<int>(s));
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(uniform(scene.seed, i, 3) * static_cast<double>(i))]);
  return order;
}

double largest_diameter(const Scene& scene) {
  double diameter = 0.0;
  for (const Species& species : scene.species)
    if (species.count > 0) diameter = std::max(diameter, species.diameter);
  return diameter;
}

/// Half the extent of the column in x and in y [m].
std::array<double, 2> half_width(const Geometry& geometry) {
  if (geometry.shape == Shape::cylinder) return {0.5 * geometry.diameter, 0.5 * geometry.diameter};
  return {0.5 * geometry.width[0], 0.5 * geometry.width[1]};
}

/// Places in one layer of the lattice, and its spacing: room for the largest sphere and its jitter around each.
struct Sites {
  double jitter, spacing, margin;  ///< margin: of a centre from what it must not touch [m]
  int x, y;
  [[nodiscard]] std::array<double, 2> at(int ix, int iy) const {
    return {(ix - 0.5 * (x - 1)) * spacing, (iy - 0.5 * (y - 1)) * spacing};
  }
};
Sites sites_of(const Scene& scene) {
  const double diameter = largest_diameter(scene);
  const bool cylinder = scene.geometry.shape == Shape::cylinder;
  const auto [half_x, half_y] = half_width(scene.geometry);
  double jitter = 0.06 * diameter;
  // In a column hardly wider than a sphere there is less room for it.
  const double room = std::min(half_x, half_y) - 0.5 * diameter;
  if (scene.fluid.wall != LateralBoundary::periodic && room < (cylinder ? jitter : jitter / std::sqrt(3.0)))
    jitter = (1.0 - 1e-9) * room;
  Sites sites{jitter, diameter + 2.0 * jitter, 0.5 * diameter + jitter, 1, 1};
  const auto count = [&](double half) {
    return std::max(1, static_cast<int>(std::floor((2.0 * half - 2.0 * sites.margin) / sites.spacing)) + 1);
  };
  sites.x = count(half_x), sites.y = count(half_y);
  // Two by two places on a square reach beyond a cylinder in which two beside one another have room.
  const auto [x, y] = sites.at(0, 0);
  if (cylinder && sites.x == 2 && std::hypot(x, y) + sites.margin > half_x) sites.y = 1;
  return sites;
}

/// `jitter` times a number between −1/√3 and 1/√3, of that item and axis.
double shift(const Scene& scene, double jitter, std::uint64_t item, std::uint64_t axis) {
  return jitter * (2.0 * uniform(scene.seed, item, axis) - 1.0) / std::sqrt(3.0);
}

/// One sphere at each place, as far as the column reaches.
std::vector<PlacedSphere> one_sphere_a_site(const Scene& scene, const std::vector<int>& order) {
  const Sites sites = sites_of(scene);
  const bool cylinder = scene.geometry.shape == Shape::cylinder;
  const double half_x = half_width(scene.geometry)[0];
  std::vector<PlacedSphere> spheres;
  spheres.reserve(order.size());
  std::uint64_t site = 0;
  for (int layer = 0; spheres.size() < order.size(); ++layer) {
    const double z = sites.margin + layer * sites.spacing;
    if (z + sites.margin > scene.geometry.height) break;
    for (int iy = 0; iy < sites.y; ++iy)
      for (int ix = 0; ix < sites.x && spheres.size() < order.size(); ++ix) {
        const auto [x, y] = sites.at(ix, iy);
        ++site;
        if (cylinder && std::hypot(x, y) + sites.margin > half_x) continue;
        const auto moved = [&](double coordinate, std::uint64_t axis) {
          return coordinate + shift(scene, sites.jitter, site, axis);
        };
        spheres.push_back({{moved(x, 0), moved(y, 1), moved(z, 2)}, order[spheres.size()]});
      }
  }
  return spheres;
}

std::int64_t places_for_the_largest(const Scene& scene) {
  const Sites sites = sites_of(scene);
  const bool cylinder = scene.geometry.shape == Shape::cylinder;
  std::int64_t in_a_layer = 0, layers = 0;
  for (int iy = 0; iy < sites.y; ++iy)
    for (int ix = 0; ix < sites.x; ++ix) {
      const auto [x, y] = sites.at(ix, iy);
      in_a_layer += cylinder && std::hypot(x, y) + sites.margin > half_width(scene.geometry)[0] ? 0 : 1;
    }
  while (sites.margin + static_cast<double>(layers) * sites.spacing + sites.margin <= scene.geometry.height) ++layers;
  return in_a_layer * layers;
}

/// At each place, in the cube around it, one of the largest spheres or as many of another size as a lattice of theirs
/// has there.
std::vector<PlacedSphere> sites_by_size(const Scene& scene, const std::vector<int>& order) {
  const Sites sites = sites_of(scene);
  const bool cylinder = scene.geometry.shape == Shape::cylinder;
  const double half_x = half_width(scene.geometry)[0];
  const auto layers =
      static_cast<std::int64_t>(std::floor((scene.geometry.height - 2.0 * sites.margin) / sites.spacing)) + 1;
  const std::int64_t in_a_layer = std::int64_t{sites.x} * sites.y, cubes = layers * in_a_layer;
  struct OpenCube {
    std::int64_t cube = -1;
    int next = 0;  ///< place in its own lattice
  };
  std::vector<OpenCube> open(scene.species.size());
  std::vector<PlacedSphere> spheres;
  spheres.reserve(order.size());
  std::int64_t used = 0;
  for (const int species : order) {
    const double diameter = scene.species[static_cast<std::size_t>(species)].diameter, jitter = 0.06 * diameter;
    const int edge = std::max(1, static_cast<int>(std::floor(sites.spacing / (diameter + 2.0 * jitter) + 1e-9)));
    OpenCube& own = open[static_cast<std::size_t>(species)];
    std::optional<std::array<double, 3>> place;
    while (!place) {
      if (own.cube < 0 || own.next == edge * edge * edge) {
        if (used == cubes) return spheres;
        own = {used++, 0};
      }
      const int q = own.next++;
      const auto column = static_cast<int>(own.cube % in_a_layer);
      const auto [cube_x, cube_y] = sites.at(column % sites.x, column / sites.x);
      const auto within = [&](int k) { return ((k + 0.5) / edge - 0.5) * sites.spacing; };
      const double x = cube_x + within(q % edge), y = cube_y + within(q / edge % edge);
      if (cylinder && std::hypot(x, y) + 0.5 * diameter + jitter > half_x) continue;
      const std::int64_t layer = own.cube / in_a_layer;
      const double z = sites.margin + static_cast<double>(layer) * sites.spacing + within(q / (edge * edge));
      const std::uint64_t item = spheres.size() + 1;
      place = {x + shift(scene, jitter, item, 0), y + shift(scene, jitter, item, 1), z + shift(scene, jitter, item, 2)};
    }
    spheres.push_back({*place, species});
  }
  return spheres;
}

std::vector<PlacedSphere> lattice(const Scene& scene) {
  const std::vector<int> order = shuffled_species(scene);
  if (order.empty()) return {};
  std::vector<PlacedSphere> spheres = one_sphere_a_site(scene, order);
  if (spheres.size() < order.size()) spheres = sites_by_size(scene, order);
  if (spheres.size() < order.size())
    throw SceneError(
        fmt::format("{} spheres do not fit loosely into the column of height {} m ({} did); "
                    "a greater height or start.arrangement = \"random\" may help",
                    order.size(), scene.geometry.height, spheres.size()));
  return spheres;
}

/// Spheres that have their place, found by cells no smaller than the largest of them.
class Neighbourhood {
 public:
  /// `half`: half the widths of the column; `height` to which it is filled; `spheres`: how many come [m]
  Neighbourhood(std::array<double, 2> half, double height, bool periodic, double largest, std::size_t spheres)
      : periodic_(periodic), lower_{-half[0], -half[1], 0.0}, extent_{2.0 * half[0], 2.0 * half[1], height} {
    double size = largest;
    const auto count = [&](std::size_t a) { return std::max(1.0, std::floor(extent_[a] / size)); };
    // A column that is nearly empty must not cost a table of empty cells.
    while (count(0) * count(1) * count(2) > 8.0 * static_cast<double>(spheres) + 64.0) size *= 1.5;
    for (std::size_t a = 0; a < 3; ++a) cells_[a] = static_cast<int>(count(a));
    newest_.assign(
        static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(cells_[2]),
        none);
    centre_.reserve(spheres);
    radius_.reserve(spheres);
    before_.reserve(spheres);
  }

  [[nodiscard]] bool has_room(const std::array<double, 3>& centre, double radius) const {
    const std::array<int, 3> own = cell_of(centre);
    std::array<std::array<int, 3>, 3> around{};
    std::array<std::size_t, 3> count{};
    for (std::size_t a = 0; a < 3; ++a)
      for (int shift = -1; shift <= 1; ++shift) {
        int c = own[a] + shift;
        if (wraps(a)) c = (c + cells_[a]) % cells_[a];
        if (c >= 0 && c < cells_[a]) around[a][count[a]++] = c;
      }
    for (std::size_t z = 0; z < count[2]; ++z)
      for (std::size_t y = 0; y < count[1]; ++y)
        for (std::size_t x = 0; x < count[0]; ++x)
          for (std::uint32_t i = newest_[index({around[0][x], around[1][y], around[2][z]})]; i != none; i = before_[i])
            if (overlap(centre, radius, i)) return false;
    return true;
  }

  void add(const std::array<double, 3>& centre, double radius) {
    std::uint32_t& newest = newest_[index(cell_of(centre))];
    before_.push_back(newest);
    newest = static_cast<std::uint32_t>(centre_.size());
    centre_.push_back(centre);
    radius_.push_back(radius);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] bool wraps(std::size_t a) const { return periodic_ && a < 2; }
  [[nodiscard]] std::array<int, 3> cell_of(const std::array<double, 3>& centre) const {
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < 3; ++a)
      cell[a] = std::clamp(static_cast<int>((centre[a] - lower_[a]) / extent_[a] * cells_[a]), 0, cells_[a] - 1);
    return cell;
  }
  [[nodiscard]] std::size_t index(const std::array<int, 3>& cell) const {
    return static_cast<std::size_t>((cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0]);
  }
  [[nodiscard]] bool overlap(const std::array<double, 3>& centre, double radius, std::uint32_t i) const {
    double squared = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      double d = centre[a] - centre_[i][a];
      if (wraps(a)) d -= extent_[a] * std::nearbyint(d / extent_[a]);
      squared += d * d;
    }
    const double sum = radius + radius_[i];
    return squared < sum * sum;
  }

  bool periodic_;
  std::array<double, 3> lower_, extent_;
  std::array<int, 3> cells_{};
  std::vector<std::uint32_t> newest_, before_;  ///< newest sphere of a cell; the one before it in the same cell
  std::vector<std::array<double, 3>> centre_;
  std::vector<double> radius_;
};

/// Places that a sphere is put at before the column counts as full: with 0.35 of it solid one in some 1500 is free.
constexpr std::uint64_t most_trials = 20000;

/// Random sequential addition up to a height, all spheres or how many found a place.
struct Addition {
  std::vector<PlacedSphere> spheres;
  std::size_t placed = 0;
};
Addition add_at_random(const Scene& scene, double height) {
  const std::vector<int> species = shuffled_species(scene);
  const std::array<double, 2> half = half_width(scene.geometry);
  const bool cylinder = scene.geometry.shape == Shape::cylinder;
  const bool periodic = scene.fluid.wall == LateralBoundary::periodic;
  const auto radius_of = [&](std::size_t i) {
    return 0.5 * scene.species[static_cast<std::size_t>(species[i])].diameter;
  };
  std::vector<std::size_t> largest_first(species.size());
  for (std::size_t i = 0; i < species.size(); ++i) largest_first[i] = i;
  std::ranges::stable_sort(largest_first, [&](std::size_t a, std::size_t b) { return radius_of(a) > radius_of(b); });

  Neighbourhood neighbourhood(half, height, periodic, largest_diameter(scene), species.size());
  Addition result{std::vector<PlacedSphere>(species.size()), 0};
  for (const std::size_t i : largest_first) {
    const double radius = radius_of(i), wall = periodic ? 0.0 : radius;
    // Uniform over where the centre may be: in a cylinder by leaving the corners of the square out.
    const std::array<double, 3> lowest{wall - half[0], wall - half[1], radius};
    const std::array<double, 3> extent{2.0 * (half[0] - wall), 2.0 * (half[1] - wall), height - 2.0 * radius};
    const double inside = half[0] - radius;
    std::optional<std::array<double, 3>> place;
    for (std::uint64_t trial = 0; !place && trial < most_trials; ++trial) {
      std::array<double, 3> centre{};
      for (std::size_t a = 0; a < 3; ++a)
        centre[a] = lowest[a] + extent[a] * uniform(scene.seed, i, a + 4 * (trial + 1));
      if (cylinder && centre[0] * centre[0] + centre[1] * centre[1] > inside * inside) continue;
      if (neighbourhood.has_room(centre, radius)) place = centre;
    }
    if (!place) break;
    neighbourhood.add(*place, radius);
    result.spheres[i] = {*place, species[i]};
    ++result.placed;
  }
  return result;
}

std::vector<PlacedSphere> random_in_column(const Scene& scene) {
  const bool empty = std::ranges::all_of(scene.species, [](const Species& species) { return species.count == 0; });
  if (empty) return {};
  const double column = scene.geometry.height;
  double height = column;
  if (scene.start.arrangement == Arrangement::random_close) {
    constexpr double solids = 0.30;  // below what sequential addition reaches, 0.38, so that places are found soon
    double volume = 0.0;
    for (const Species& species : scene.species) volume += static_cast<double>(species.count) * species.volume();
    height =
        std::min(column, std::max(volume / (solids * scene.geometry.cross_section()), 2.0 * largest_diameter(scene)));
  }
  for (;;) {
    Addition addition = add_at_random(scene, height);
    const std::size_t wanted = addition.spheres.size();
    if (addition.placed == wanted) return std::move(addition.spheres);
    if (height >= column)
      throw SceneError(fmt::format(
          "{} of {} spheres find a place at random in the column of height {} m (random addition "
          "ends "
          "near a solids fraction of 0.35, less between near walls); fewer spheres, a greater height, or arrangement = "
          "\"lattice\" may help",
          addition.placed, wanted, column));
    height = std::min(column, 1.1 * height);
  }
}

}  // namespace

std::vector<PlacedSphere> start_positions(const Scene& scene) {
  return scene.start.arrangement == Arrangement::lattice ? lattice(scene) : random_in_column(scene);
}

std::string start_problem(const Scene& scene) {
  std::int64_t spheres = 0;
  double volume = 0.0;
  for (const Species& species : scene.species) {
    spheres += species.count;
    volume += static_cast<double>(species.count) * species.volume();
  }
  if (spheres == 0 || spheres > 10'000'000) return {};
  const Geometry& geometry = scene.geometry;
  const bool much_room = scene.start.arrangement == Arrangement::lattice
                             ? places_for_the_largest(scene) >= spheres
                             : volume < 0.15 * geometry.cross_section() * geometry.height;
  if (much_room) return {};
  try {
    start_positions(scene);
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

}  // namespace slfb::dem
