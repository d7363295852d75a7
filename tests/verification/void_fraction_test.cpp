// Void fraction: exact overlap against independent integration, conservation of the solid volume in every scheme.
#include "solver/coupling/void_fraction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "solver/coupling/sphere_overlap.hpp"

namespace slfb::coupling {
namespace {

constexpr double ball = 4.0 / 3.0 * std::numbers::pi;

TEST(SphereOverlap, KnowsTheSimplePieces) {
  EXPECT_NEAR(unit_ball_octant(-1, -1, -1), ball, 1e-14);
  EXPECT_NEAR(unit_ball_octant(0, 0, 0), ball / 8, 1e-14);
  EXPECT_NEAR(unit_ball_octant(0, 0, -1), ball / 4, 1e-14);
  const double h = 0.3;  // cap of height h: π h² (3 − h)/3
  EXPECT_NEAR(unit_ball_octant(1 - h, -1, -1), std::numbers::pi * h * h * (3 - h) / 3, 1e-14);
  EXPECT_EQ(unit_ball_octant(0.6, 0.6, 0.6), 0.0);
}

// Independent method: the chord length integrated over the plane by the midpoint rule.
TEST(SphereOverlap, AgreesWithQuadrature) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int trial = 0; trial < 10; ++trial) {
    const double a = uniform(generator), b = uniform(generator), c = uniform(generator);
    constexpr int n = 500;
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double x = a + (1 - a) * (i + 0.5) / n, y = b + (1 - b) * (j + 0.5) / n;
        const double half = std::sqrt(std::max(0.0, 1 - x * x - y * y));
        sum += std::max(0.0, half - std::max(c, -half));
      }
    EXPECT_NEAR(unit_ball_octant(a, b, c), sum * (1 - a) * (1 - b) / n / n, 2e-5);
  }
}

// Boxes that tile the space share the whole sphere, wherever it lies and however small the boxes are.
TEST(SphereOverlap, TilingBoxesShareTheWholeSphere) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (double width : {0.2, 0.5, 1.0, 3.0}) {
    const std::array<double, 3> centre{uniform(generator), uniform(generator), uniform(generator)};
    double sum = 0.0;
    const int most = static_cast<int>(2.0 / width) + 2;
    for (int i = -most; i <= most; ++i)
      for (int j = -most; j <= most; ++j)
        for (int k = -most; k <= most; ++k)
          sum += sphere_box_overlap(centre, 0.5, {i * width, j * width, k * width},
                                    {(i + 1) * width, (j + 1) * width, (k + 1) * width});
    EXPECT_NEAR(sum, ball / 8, 1e-12) << width;
  }
}

Scene column(int cells_across) {
  Scene scene;
  scene.geometry.diameter = 0.05;
  scene.geometry.height = 0.1;
  scene.fluid.cells_across = cells_across;
  scene.fluid.cell_height = 0.05 / cells_across;
  return scene;
}

dem::Particles spheres_in_column() {
  dem::Particles particles;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double r = 0.003, angle = 2 * std::numbers::pi * uniform(generator);
    // Some touch the wall and the bottom, some press into them, as contacts do.
    const double distance = i % 3 == 0 ? 0.025 - 0.999 * r : (0.025 - r) * std::sqrt(uniform(generator));
    const double z = i % 5 == 0 ? 0.998 * r : r + (0.1 - 2 * r) * uniform(generator);
    particles.add({distance * std::cos(angle), distance * std::sin(angle), z}, r, 2230, 0);
  }
  return particles;
}

TEST(VoidFraction, EverySchemeKeepsTheSolidVolume) {
  const dem::Particles particles = spheres_in_column();
  std::vector<double> volumes(particles.size());
  for (std::size_t i = 0; i < volumes.size(); ++i) volumes[i] = particles.volume(i);
  const double total = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  for (int cells : {3, 7, 8, 20}) {
    const fluid::ColumnGrid grid(column(cells));
    for (auto scheme :
         {VoidFractionScheme::centroid, VoidFractionScheme::particle_meshing, VoidFractionScheme::exact_overlap}) {
      VolumeShares shares(scheme, 1214, grid, 0.003);
      shares.update(particles, 1);
      std::vector<double> solid;
      shares.scatter(volumes, solid);
      EXPECT_NEAR(std::accumulate(solid.begin(), solid.end(), 0.0), total, 1e-12 * total);
      for (std::size_t i = 0; i < particles.size(); ++i)
        EXPECT_NEAR(shares.gather(i, std::vector<double>(grid.size(), 1.0)), 1.0, 1e-12);
    }
  }
}

// Many pieces approach the exact overlap; the paper's 1214 are within two per cent of the sphere's volume per cell.
TEST(VoidFraction, ParticleMeshingConvergesToTheExactOverlap) {
  const fluid::ColumnGrid grid(column(8));
  const dem::Particles particles = spheres_in_column();
  const auto error = [&](int pieces) {
    VolumeShares exact(VoidFractionScheme::exact_overlap, 1, grid, 0.003);
    VolumeShares meshed(VoidFractionScheme::particle_meshing, pieces, grid, 0.003);
    exact.update(particles, 1);
    meshed.update(particles, 1);
    double worst = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      std::vector<double> difference(grid.size(), 0.0);
      for (int m = 0; m < exact.count(i); ++m) difference[exact.cells(i)[m]] += exact.shares(i)[m];
      for (int m = 0; m < meshed.count(i); ++m) difference[meshed.cells(i)[m]] -= meshed.shares(i)[m];
      for (double d : difference) worst = std::max(worst, std::abs(d));
    }
    return worst;
  };
  EXPECT_LT(error(1214), 0.03);
  EXPECT_LT(error(20000), 0.5 * error(1214));
}

TEST(MeshingTemplate, HasTheBallsCentreAndSecondMoment) {
  for (int pieces : {1, 20, 1214, 5000}) {
    const auto centroids = VolumeShares::meshing_template(pieces);
    ASSERT_EQ(centroids.size(), static_cast<std::size_t>(pieces));
    std::array<double, 3> mean{};
    double second = 0.0;
    for (const auto& c : centroids)
      for (std::size_t a = 0; a < 3; ++a) {
        mean[a] += c[a] / pieces;
        second += c[a] * c[a] / pieces;
      }
    for (double m : mean) EXPECT_NEAR(m, 0.0, pieces > 1000 ? 0.02 : 0.3);
    if (pieces > 1000) {
      EXPECT_NEAR(second, 0.6, 0.005);  // ⟨r²⟩ of a ball is 3/5
    }
  }
}

}  // namespace
}  // namespace slfb::coupling
