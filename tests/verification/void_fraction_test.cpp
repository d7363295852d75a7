// Void fraction: exact overlap against independent integration, conservation of the solid volume in every scheme.
#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "solver/coupling/void_fraction/particle_meshing.hpp"
#include "solver/coupling/void_fraction/sphere_overlap.hpp"
#include "solver/coupling/volume_shares.hpp"

namespace slfb::coupling {
namespace {

std::unique_ptr<ShareScheme> scheme_of(VoidFractionScheme scheme, int pieces = 1) {
  Coupling keys;
  keys.void_fraction = scheme;
  keys.meshing_pieces = pieces;
  return make_share_scheme(keys);
}

/// Fraction of the unit ball in a box, in lengths of the ball's radius from its centre.
double box_fraction(const std::array<double, 3>& lower, const std::array<double, 3>& upper) {
  const auto row = [&](std::size_t a) { return PlaneRow{lower[a], upper[a] - lower[a], 2}; };
  std::array<double, 27> parts;
  unit_ball_parts(row(0), row(1), row(2), parts.data());
  return parts[13];  // the middle one of 3 x 3 x 3
}

/// Independent method: areas of the sections x = const, chord by chord in closed form, integrated by GSL between the
/// places where the section's circle starts to meet another side or corner of the box.
class BoxQuadrature {
 public:
  BoxQuadrature() : workspace_(gsl_integration_cquad_workspace_alloc(400)) {}
  BoxQuadrature(const BoxQuadrature&) = delete;
  BoxQuadrature& operator=(const BoxQuadrature&) = delete;
  ~BoxQuadrature() { gsl_integration_cquad_workspace_free(workspace_); }

  double fraction(const std::array<double, 3>& lower, const std::array<double, 3>& upper) {
    lower_ = lower;
    upper_ = upper;
    std::vector<double> ends{std::max(-1.0, lower[0]), std::min(1.0, upper[0])};
    if (ends[0] >= ends[1]) return 0.0;
    for (const double y : {0.0, lower[1], upper[1]})
      for (const double z : {0.0, lower[2], upper[2]})
        for (const double sign : {-1.0, 1.0}) {
          const double x = sign * std::sqrt(std::max(0.0, 1.0 - y * y - z * z));
          if (x > ends[0] && x < ends[1]) ends.push_back(x);
        }
    std::ranges::sort(ends);
    gsl_function section{[](double x, void* self) { return static_cast<BoxQuadrature*>(self)->area(x); }, this};
    double volume = 0.0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      if (ends[k] - ends[k - 1] < 1e-14) continue;
      double part = 0.0;
      gsl_integration_cquad(&section, ends[k - 1], ends[k], 1e-15, 1e-13, workspace_, &part, nullptr, nullptr);
      volume += part;
    }
    return volume / (4.0 / 3.0 * std::numbers::pi);
  }

 private:
  [[nodiscard]] double area(double x) const {
    const long double squared = 1.0L - static_cast<long double>(x) * x, rho = std::sqrt(std::max(0.0L, squared));
    const long double z0 = lower_[2], z1 = upper_[2];
    std::vector<long double> ends{std::max<long double>(-rho, lower_[1]), std::min<long double>(rho, upper_[1])};
    if (ends[0] >= ends[1]) return 0.0;
    for (const long double z : {z0, z1})
      for (const long double sign : {-1.0L, 1.0L}) {
        const long double y = sign * std::sqrt(std::max(0.0L, squared - z * z));
        if (y > ends[0] && y < ends[1]) ends.push_back(y);
      }
    std::ranges::sort(ends);
    const auto under_circle = [&](long double y) {
      const long double s = std::clamp(y / rho, -1.0L, 1.0L);
      return 0.5L * squared * (s * std::sqrt(1.0L - s * s) + std::asin(s));
    };
    long double sum = 0.0L;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const long double middle = 0.5L * (ends[k] + ends[k - 1]), width = ends[k] - ends[k - 1];
      const long double half = std::sqrt(std::max(0.0L, squared - middle * middle));
      if (std::min(z1, half) <= std::max(z0, -half)) continue;
      const long double circle = under_circle(ends[k]) - under_circle(ends[k - 1]);
      sum += (z1 < half ? z1 * width : circle) - (z0 > -half ? z0 * width : -circle);
    }
    return static_cast<double>(sum);
  }

  gsl_integration_cquad_workspace* workspace_;
  std::array<double, 3> lower_{}, upper_{};
};

TEST(SphereOverlap, KnowsTheSimplePieces) {
  const auto beyond = [](double a, double b, double c) { return box_fraction({a, b, c}, {2.0, 2.0, 2.0}); };
  EXPECT_NEAR(beyond(-1, -1, -1), 1.0, 1e-15);
  EXPECT_NEAR(beyond(0, 0, 0), 1.0 / 8, 1e-15);
  EXPECT_NEAR(beyond(0, -1, 0), 1.0 / 4, 1e-15);
  const double h = 0.3;  // cap of height h: π h² (3 − h)/3
  EXPECT_NEAR(beyond(1 - h, -1, -1), h * h * (3 - h) / 4, 1e-15);
  EXPECT_EQ(beyond(0.6, 0.6, 0.6), 0.0);
}

TEST(SphereOverlap, AgreesWithQuadratureInRandomBoxes) {
  BoxQuadrature quadrature;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double width : {0.03, 0.3, 1.0, 3.0, 30.0})
    for (int trial = 0; trial < 200; ++trial) {
      std::array<double, 3> lower{}, upper{};
      for (std::size_t a = 0; a < 3; ++a) {
        lower[a] = uniform(generator) - (trial % 2 == 0 ? 0.5 * width : 0.0);
        upper[a] = lower[a] + width * (1.0 + 0.5 * uniform(generator));
      }
      EXPECT_NEAR(box_fraction(lower, upper), quadrature.fraction(lower, upper), 1e-13)
          << "from " << lower[0] << ' ' << lower[1] << ' ' << lower[2] << ", width " << width;
    }
}

// Sides through the centre, sides, edges and corners on the surface or a hair to either side of it.
TEST(SphereOverlap, AgreesWithQuadratureAtTangencies) {
  BoxQuadrature quadrature;
  const double corner = 1.0 / std::sqrt(3.0), edge = 1.0 / std::sqrt(2.0);
  for (const double hair : {0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, -1e-15, -1e-12, -1e-9, -1e-7, -1e-5, -1e-3})
    for (const auto& [a, b, c] : std::vector<std::array<double, 3>>{{corner, corner, corner},
                                                                    {2.0 / 3, 2.0 / 3, 1.0 / 3},
                                                                    {0.6, 0.8, 0.0},
                                                                    {edge, edge, 0.0},
                                                                    {1.0, 0.0, 0.0},
                                                                    {1.0, 0.5, -0.5},
                                                                    {0.0, 0.0, 0.0},
                                                                    {0.6, 0.8, -2.0},
                                                                    {1.0, -2.0, -2.0}})
      for (int signs = 0; signs < 8; ++signs) {
        const std::array<double, 3> lower{(signs & 1 ? -a : a) * (1 - hair), (signs & 2 ? -b : b) * (1 - hair),
                                          (signs & 4 ? -c : c) * (1 - hair)};
        const std::array<double, 3> upper{lower[0] + 2.5, lower[1] + 2.5, lower[2] + 2.5};
        EXPECT_NEAR(box_fraction(lower, upper), quadrature.fraction(lower, upper), 1e-14)
            << lower[0] << ' ' << lower[1] << ' ' << lower[2] << ", hair " << hair;
      }
}

// Boxes that tile the space share the whole sphere, wherever it lies and however small they are; none is negative.
TEST(SphereOverlap, TilingBoxesShareTheWholeSphere) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const double width : {0.07, 0.4, 1.0, 2.0, 6.0}) {
    std::array<PlaneRow, 3> rows;
    std::size_t boxes = 1;
    for (auto& row : rows) {
      row = {-1.0 + width * uniform(generator), width, 0};
      while (row[row.count] < 1.0) ++row.count;
      boxes *= static_cast<std::size_t>(row.count) + 1;
    }
    std::vector<double> parts(boxes);
    unit_ball_parts(rows[0], rows[1], rows[2], parts.data());
    EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0), 1.0, 1e-13) << width;
    EXPECT_GT(*std::ranges::min_element(parts), -1e-15) << width;
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
      VolumeShares shares(scheme_of(scheme, 1214), grid, 0.003);
      shares.update(particles, 1);
      std::vector<double> solid;
      shares.scatter(volumes, solid);
      EXPECT_NEAR(std::accumulate(solid.begin(), solid.end(), 0.0), total, 1e-14 * total);
      for (std::size_t i = 0; i < particles.size(); ++i)
        EXPECT_NEAR(shares.gather(i, std::vector<double>(grid.size(), 1.0)), 1.0, 1e-14);
    }
  }
}

// Inside the section a share is the volume in the cell's own box; cells of another depth than width tell x from y.
TEST(VoidFraction, ExactSharesAreTheVolumesInTheCells) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.05, 0.018};
  scene.geometry.height = 0.05;
  scene.fluid.cells_across = 16;
  scene.fluid.cell_height = 0.005;
  const fluid::ColumnGrid grid(scene);
  const std::array<double, 3> width{grid.spacing(0), grid.spacing(1), grid.cell_height()};
  const double r = 0.0045;
  dem::Particles particles;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 10; ++i)
    particles.add({0.02 * uniform(generator), 0.0044 * uniform(generator), 0.025 + 0.02 * uniform(generator)}, r, 2230,
                  0);
  VolumeShares shares(scheme_of(VoidFractionScheme::exact_overlap), grid, r);
  shares.update(particles, 1);
  BoxQuadrature quadrature;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto x = particles.position.at(i);
    EXPECT_GT(shares.count(i), 8);
    for (int m = 0; m < shares.count(i); ++m) {
      const int cell = static_cast<int>(shares.cells(i)[m]) / grid.layers(),
                layer = static_cast<int>(shares.cells(i)[m]) % grid.layers();
      const std::array<double, 3> centre{grid.centre(cell)[0], grid.centre(cell)[1], (layer + 0.5) * width[2]};
      std::array<double, 3> lower{}, upper{};
      for (std::size_t a = 0; a < 3; ++a) {
        lower[a] = (centre[a] - 0.5 * width[a] - x[a]) / r;
        upper[a] = (centre[a] + 0.5 * width[a] - x[a]) / r;
      }
      EXPECT_NEAR(shares.shares(i)[m], quadrature.fraction(lower, upper), 1e-13);
    }
  }
}

// Across a periodic side nothing is special: moved by a cell, every sphere has the same shares one cell further.
TEST(VoidFraction, PeriodicSidesAreLikeAnyOther) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {0.02, 0.02};
  scene.geometry.height = 0.02;
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cells_across = 5;
  scene.fluid.cell_height = 0.004;
  const fluid::ColumnGrid grid(scene);
  for (auto scheme :
       {VoidFractionScheme::centroid, VoidFractionScheme::particle_meshing, VoidFractionScheme::exact_overlap}) {
    dem::Particles particles;
    for (int shift = 0; shift < 5; ++shift)
      particles.add({-0.0094 + 0.004 * shift, -0.0097 + 0.004 * shift, 0.0101}, 0.003, 2230, 0);
    VolumeShares shares(scheme_of(scheme, 1214), grid, 0.003);
    shares.update(particles, 1);
    const auto share_at = [&](std::size_t i, int ix, int iy, int layer) {
      for (int m = 0; m < shares.count(i); ++m)
        if (static_cast<int>(shares.cells(i)[m]) == grid.cell_of_square(ix, iy) * grid.layers() + layer)
          return shares.shares(i)[m];
      return 0.0;
    };
    for (int shift = 1; shift < 5; ++shift)
      for (int ix = 0; ix < 5; ++ix)
        for (int iy = 0; iy < 5; ++iy)
          for (int layer = 0; layer < 5; ++layer)
            EXPECT_NEAR(share_at(static_cast<std::size_t>(shift), (ix + shift) % 5, (iy + shift) % 5, layer),
                        share_at(0, ix, iy, layer), 1e-14);
  }
}

TEST(VoidFraction, ScatterIsTheSameAtAnyNumberOfThreads) {
  const dem::Particles particles = spheres_in_column();
  const fluid::ColumnGrid grid(column(8));
  VolumeShares shares(scheme_of(VoidFractionScheme::exact_overlap), grid, 0.003);
  shares.update(particles, 1);
  // The definition: sphere after sphere.
  const auto& values = particles.position.x;
  std::vector<double> expected(grid.size(), 0.0);
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (int m = 0; m < shares.count(i); ++m) expected[shares.cells(i)[m]] += shares.shares(i)[m] * values[i];
  std::vector<double> alone;
  shares.scatter(values, alone);
  for (std::size_t c = 0; c < grid.size(); ++c) EXPECT_NEAR(alone[c], expected[c], 1e-16) << c;
  for (const int threads : {1, 2, 3, 7}) {
    shares.update(particles, threads);
    std::vector<double> first, second;
    shares.scatter<2>({&particles.position.z, &values}, {&first, &second}, threads);
    EXPECT_EQ(second, alone) << threads;
  }
}

// Many pieces approach the exact overlap; the paper's 1214 are within two per cent of the sphere's volume per cell.
TEST(VoidFraction, ParticleMeshingConvergesToTheExactOverlap) {
  const fluid::ColumnGrid grid(column(8));
  const dem::Particles particles = spheres_in_column();
  const auto error = [&](int pieces) {
    VolumeShares exact(scheme_of(VoidFractionScheme::exact_overlap), grid, 0.003);
    VolumeShares meshed(scheme_of(VoidFractionScheme::particle_meshing, pieces), grid, 0.003);
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

// Eqs. 32-34 of Peng 2014 word by word: every piece of a sphere lies whole in the cell that holds its centroid. In
// cells larger than the sphere, and in small ones, where a sphere spans several.
TEST(VoidFraction, ParticleMeshingCountsThePiecesInEachCell) {
  constexpr int pieces = 500;
  const auto centroids = meshing_template(pieces);
  const dem::Particles particles = spheres_in_column();
  for (int cells : {5, 7, 12, 30}) {
    const fluid::ColumnGrid grid(column(cells));
    VolumeShares meshed(scheme_of(VoidFractionScheme::particle_meshing, pieces), grid, 0.003);
    meshed.update(particles, 1);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const std::array<double, 3> x = particles.position.at(i);
      const double r = particles.radius[i];
      if (std::hypot(x[0], x[1]) + r > 0.017 || x[2] < r) continue;  // whole squares only
      std::vector<int> expected(grid.size(), 0);
      for (const auto& piece : centroids) {
        const auto square = [&](std::size_t a) {
          return static_cast<int>(std::floor((x[a] + r * piece[a] - grid.lower(a)) / grid.spacing(a)));
        };
        const int layer = static_cast<int>(std::floor((x[2] + r * piece[2]) / grid.cell_height()));
        ++expected[static_cast<std::size_t>(grid.cell_of_square(square(0), square(1)) * grid.layers() + layer)];
      }
      for (int m = 0; m < meshed.count(i); ++m) {
        int& count = expected[meshed.cells(i)[m]];
        EXPECT_NEAR(meshed.shares(i)[m] * pieces, count, 1e-9) << "sphere " << i << ", " << cells << " cells across";
        count = 0;
      }
      EXPECT_EQ(std::accumulate(expected.begin(), expected.end(), 0), 0) << "a cell is missing, sphere " << i;
    }
  }
}

TEST(MeshingTemplate, HasTheBallsCentreAndSecondMoment) {
  for (int pieces : {1, 20, 1214, 5000}) {
    const auto centroids = meshing_template(pieces);
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
