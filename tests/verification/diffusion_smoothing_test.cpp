// Smoothing by diffusion: what it keeps, how far it spreads, and that scatter and gather are each other's transpose.
#include "solver/coupling/diffusion_smoothing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace slfb::coupling {
namespace {

Scene box(std::array<double, 3> extent, int cells_across, double cell_height, LateralBoundary wall) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {extent[0], extent[1]};
  scene.geometry.height = extent[2];
  scene.fluid.wall = wall;
  scene.fluid.cells_across = cells_across;
  scene.fluid.cell_height = cell_height;
  return scene;
}

Scene cylinder(int cells_across) {
  Scene scene;
  scene.geometry.diameter = 0.05;
  scene.geometry.height = 0.08;
  scene.fluid.cells_across = cells_across;
  scene.fluid.cell_height = 0.005;
  return scene;
}

/// Round with cut cells, a box with walls, a periodic box two cells deep, a plane box and a single column.
std::vector<Scene> scenes() {
  Scene column = cylinder(8);
  column.fluid.tier = FluidTier::one_dimensional;
  return {cylinder(8),
          cylinder(11),
          box({0.05, 0.03, 0.08}, 8, 0.007, LateralBoundary::no_slip),
          box({0.05, 0.012, 0.08}, 8, 0.007, LateralBoundary::periodic),
          box({0.05, 0.005, 0.08}, 8, 0.007, LateralBoundary::no_slip),
          column};
}

std::vector<double> random_field(std::size_t size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> field(size);
  for (double& value : field) value = uniform(generator);
  return field;
}

double sum(const std::vector<double>& field) { return std::accumulate(field.begin(), field.end(), 0.0); }

constexpr double length = 0.015;

TEST(DiffusionSmoothing, ScatterKeepsTheSumAndNothingBecomesNegative) {
  for (const Scene& scene : scenes()) {
    const fluid::ColumnGrid grid(scene);
    DiffusionSmoothing smoothing(grid, length);
    ASSERT_GT(smoothing.steps(), 1);
    auto content = random_field(grid.size(), 1);
    const double before = sum(content);
    smoothing.scatter(content);
    EXPECT_NEAR(sum(content), before, 1e-14 * before);
    for (std::size_t cell = 0; cell < grid.size(); cell += 7) {
      std::vector<double> one(grid.size(), 0.0);
      one[cell] = 1.0;
      smoothing.scatter(one);
      EXPECT_NEAR(sum(one), 1.0, 1e-14);
      EXPECT_GE(*std::ranges::min_element(one), 0.0);
    }
  }
}

TEST(DiffusionSmoothing, ScatterAndGatherAreTransposes) {
  for (const Scene& scene : scenes()) {
    const fluid::ColumnGrid grid(scene);
    DiffusionSmoothing smoothing(grid, length);
    const auto content = random_field(grid.size(), 2), field = random_field(grid.size(), 3);
    auto scattered = content, gathered = field;
    smoothing.scatter(scattered);
    smoothing.gather(gathered);
    const double work = std::inner_product(scattered.begin(), scattered.end(), field.begin(), 0.0);
    EXPECT_NEAR(std::inner_product(content.begin(), content.end(), gathered.begin(), 0.0), work, 1e-14 * work);
  }
}

TEST(DiffusionSmoothing, UniformFieldsStay) {
  for (const Scene& scene : scenes()) {
    const fluid::ColumnGrid grid(scene);
    DiffusionSmoothing smoothing(grid, length);
    std::vector<double> field(grid.size(), 0.55), content(grid.size());
    for (std::size_t n = 0; n < grid.size(); ++n)
      content[n] = 0.45 * grid.volume(static_cast<int>(n) / grid.layers());  // a uniform solids fraction
    const auto solid = content;
    smoothing.gather(field);
    smoothing.scatter(content);
    for (std::size_t n = 0; n < grid.size(); ++n) {
      EXPECT_NEAR(field[n], 0.55, 1e-15);
      EXPECT_NEAR(content[n], solid[n], 1e-14 * solid[n]);
    }
  }
}

TEST(DiffusionSmoothing, NoLengthChangesNothing) {
  const fluid::ColumnGrid grid(cylinder(8));
  DiffusionSmoothing off(grid, 0.0);
  const auto before = random_field(grid.size(), 4);
  auto content = before, field = before;
  off.scatter(content);
  off.gather(field);
  EXPECT_EQ(content, before);
  EXPECT_EQ(field, before);
}

TEST(DiffusionSmoothing, IsTheSameAtAnyNumberOfThreads) {
  const fluid::ColumnGrid grid(cylinder(8));
  DiffusionSmoothing smoothing(grid, length);
  auto alone = random_field(grid.size(), 5), together = alone;
  smoothing.scatter(alone, 1);
  smoothing.scatter(together, 3);
  EXPECT_EQ(alone, together);
}

// A point far from the walls: mass 1, centre kept, variance b²/2 along every axis whatever the cells' proportions.
TEST(DiffusionSmoothing, APointSpreadsAsTheGaussian) {
  const fluid::ColumnGrid grid(box({0.062, 0.0465, 0.075}, 31, 0.003, LateralBoundary::no_slip));
  ASSERT_NEAR(grid.spacing(1), 0.002, 3e-5);
  const double b = 0.004;
  DiffusionSmoothing smoothing(grid, b);
  ASSERT_LT(smoothing.steps(), 12) << "the point must not reach the walls";
  std::vector<double> content(grid.size(), 0.0);
  const auto index = [&](int ix, int iy, int layer) {
    return static_cast<std::size_t>(grid.cell_of_square(ix, iy) * grid.layers() + layer);
  };
  const std::array<int, 3> middle{15, grid.squares(1) / 2, grid.layers() / 2};
  content[index(middle[0], middle[1], middle[2])] = 1.0;
  smoothing.scatter(content);
  std::array<double, 3> first{}, second{};
  const std::array<double, 3> width{grid.spacing(0), grid.spacing(1), grid.cell_height()};
  for (int ix = 0; ix < grid.squares(0); ++ix)
    for (int iy = 0; iy < grid.squares(1); ++iy)
      for (int layer = 0; layer < grid.layers(); ++layer) {
        const std::array<int, 3> place{ix, iy, layer};
        for (std::size_t a = 0; a < 3; ++a) {
          const double x = (place[a] - middle[a]) * width[a], share = content[index(ix, iy, layer)];
          first[a] += share * x;
          second[a] += share * x * x;
        }
      }
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_NEAR(first[a], 0.0, 1e-14 * b);
    EXPECT_NEAR(second[a], b * b / 2, 1e-12 * b * b) << "axis " << a;
  }
}

// Cubes know no axis: exchanging any two coordinates changes nothing, walls included.
TEST(DiffusionSmoothing, AxesAreAlike) {
  const int n = 7;
  const fluid::ColumnGrid grid(box({0.007, 0.007, 0.007}, n, 0.001, LateralBoundary::no_slip));
  DiffusionSmoothing smoothing(grid, 0.004);
  std::vector<double> content(grid.size(), 0.0);
  const auto index = [&](int ix, int iy, int layer) {
    return static_cast<std::size_t>(grid.cell_of_square(ix, iy) * n + layer);
  };
  content[index(1, 1, 1)] = 1.0;
  smoothing.scatter(content);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        EXPECT_NEAR(content[index(i, j, k)], content[index(j, i, k)], 1e-16);
        EXPECT_NEAR(content[index(i, j, k)], content[index(k, j, i)], 1e-16);
      }
}

// A standing wave between walls, longer than cells and b: the Gaussian damps it by exp(−k²b²/4).
TEST(DiffusionSmoothing, WavesAreDampedAsByTheGaussian) {
  const fluid::ColumnGrid grid(box({0.04, 0.004, 0.04}, 40, 0.001, LateralBoundary::no_slip));
  const double b = 0.008, k = std::numbers::pi / 0.04;
  DiffusionSmoothing smoothing(grid, b);
  std::vector<double> field(grid.size());
  const auto layers = static_cast<std::size_t>(grid.layers());
  const auto wave = [&](std::size_t n) {
    return std::cos(k * (grid.centre(static_cast<int>(n / layers))[0] + 0.02)) *
           std::cos(2 * k * grid.cell_height() * (static_cast<double>(n % layers) + 0.5));
  };
  for (std::size_t n = 0; n < field.size(); ++n) field[n] = wave(n);
  smoothing.gather(field);
  const double damping = std::exp(-(k * k + 4 * k * k) * b * b / 4);
  for (std::size_t n = 0; n < field.size(); ++n) EXPECT_NEAR(field[n], damping * wave(n), 2e-3);
}

}  // namespace
}  // namespace slfb::coupling
