#include "experiments/numerics/studies/scheme_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "solver/coupling/diffusion_smoothing.hpp"
#include "solver/coupling/volume_shares.hpp"
#include "solver/support/processor.hpp"

namespace slfb::void_fraction_study {
namespace {

/// Cubes of width `cell`, periodic in x and y.
Scene cubes(int across, int layers, double cell) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {across * cell, across * cell};
  scene.geometry.height = layers * cell;
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cells_across = across;
  scene.fluid.cell_height = cell;
  return scene;
}

constexpr double sphere_volume = std::numbers::pi / 6.0;

std::unique_ptr<coupling::ShareScheme> scheme_of(const Method& method) {
  Coupling keys;
  keys.void_fraction = method.scheme;
  keys.meshing_pieces = method.pieces;
  return coupling::make_share_scheme(keys);
}

/// Volume of spheres in each cell.
class Sharing {
 public:
  Sharing(const Method& method, const fluid::ColumnGrid& grid)
      : shares_(scheme_of(method), grid, 0.5), smoothing_(grid, method.smoothing) {}

  const std::vector<double>& operator()(const dem::Particles& spheres) {
    volumes_.assign(spheres.size(), sphere_volume);
    shares_.update(spheres, 1);
    shares_.scatter(volumes_, solid_);
    smoothing_.scatter(solid_);
    return solid_;
  }

 private:
  coupling::VolumeShares shares_;
  coupling::DiffusionSmoothing smoothing_;
  std::vector<double> volumes_, solid_;
};

}  // namespace

const std::vector<Method>& methods() {
  using enum VoidFractionScheme;
  static const std::vector<Method> list{{"centroid", centroid, 1, 0.0},
                                        {"8 pieces", particle_meshing, 8, 0.0},
                                        {"64 pieces", particle_meshing, 64, 0.0},
                                        {"343 pieces", particle_meshing, 343, 0.0},
                                        {"1214 pieces", particle_meshing, 1214, 0.0},
                                        {"10000 pieces", particle_meshing, 10000, 0.0},
                                        {"exact overlap", exact_overlap, 1, 0.0},
                                        {"centroid + diffusion", centroid, 1, 1.0},
                                        {"exact overlap + diffusion", exact_overlap, 1, 1.0}};
  return list;
}

std::vector<Outcome> compare(const Assembly& assembly, int across, int placements, double timed,
                             const std::vector<Method>& candidates) {
  const double cell = assembly.side / across;
  // A slab of the assembly with about as many cells for any width of them. The column is not periodic upwards: spheres
  // go on below and above the slab as far as the smoothing reaches.
  constexpr double reach = 3.0;
  const int layers = std::clamp(4000 / (across * across), 2, across);
  const int margin = static_cast<int>(std::ceil(reach / cell));
  const fluid::ColumnGrid grid(cubes(across, layers + 2 * margin, cell));
  const double cell_volume = cell * cell * cell, bottom = margin * cell, top = bottom + layers * cell;

  Sharing exact({"", VoidFractionScheme::exact_overlap, 1, 0.0}, grid);
  std::vector<Sharing> sharings;
  for (const Method& method : candidates) sharings.emplace_back(method, grid);
  std::vector<Outcome> outcomes(candidates.size(), {0.0, 0.0, std::numeric_limits<double>::infinity()});
  double solids = 0.0;
  std::mt19937_64 generator(1);
  for (int placement = 0; placement < placements; ++placement) {
    std::array<double, 3> shift{};
    for (double& s : shift) s = assembly.side * static_cast<double>(generator() >> 11) * 0x1p-53;
    dem::Particles spheres;
    const auto within = [&](double x) { return x - assembly.side * std::floor(x / assembly.side); };
    for (const auto& centre : assembly.centres) {
      const double x = within(centre[0] + shift[0]) - 0.5 * assembly.side,
                   y = within(centre[1] + shift[1]) - 0.5 * assembly.side;
      for (double z = within(centre[2] + shift[2]); z < top + reach; z += assembly.side)
        if (z > bottom - reach) spheres.add({x, y, z}, 0.5, 1.0, 0);
    }
    const auto truth = exact(spheres);
    const auto interior = [&](auto visit) {
      for (std::size_t c = 0; c < grid.size(); ++c) {
        const int layer = static_cast<int>(c) % grid.layers();
        if (layer >= margin && layer < margin + layers) visit(c);
      }
    };
    interior([&](std::size_t c) { solids += truth[c] / cell_volume; });
    for (std::size_t m = 0; m < candidates.size(); ++m) {
      Outcome& outcome = outcomes[m];
      const std::vector<double>* found = nullptr;
      double spent = 0.0;
      do {
        const double start = thread_cpu_seconds();
        found = &sharings[m](spheres);
        const double seconds = thread_cpu_seconds() - start;
        outcome.nanoseconds = std::min(outcome.nanoseconds, 1e9 * seconds / static_cast<double>(spheres.size()));
        spent += seconds;
      } while (spent < timed);
      interior([&](std::size_t c) {
        const double error = ((*found)[c] - truth[c]) / cell_volume;
        outcome.root_mean_square += error * error;
        outcome.largest = std::max(outcome.largest, std::abs(error));
      });
    }
  }
  const double cells = static_cast<double>(placements) * across * across * layers, mean = solids / cells;
  for (Outcome& outcome : outcomes) {
    outcome.root_mean_square = std::sqrt(outcome.root_mean_square / cells) / mean;
    outcome.largest /= mean;
  }
  return outcomes;
}

std::vector<double> crossing(const Method& method, double cell, const std::vector<double>& distances) {
  constexpr int across = 9, middle = across / 2;
  const fluid::ColumnGrid grid(cubes(across, across, cell));
  Sharing sharing(method, grid);
  const auto watched = static_cast<std::size_t>(grid.cell_of_square(middle, middle) * grid.layers() + middle);
  std::vector<double> parts;
  for (const double distance : distances) {
    dem::Particles sphere;
    sphere.add({-0.5 * cell + distance, 0.0, 0.5 * grid.column_height()}, 0.5, 1.0, 0);
    parts.push_back(sharing(sphere)[watched] / sphere_volume);
  }
  return parts;
}

}  // namespace slfb::void_fraction_study
