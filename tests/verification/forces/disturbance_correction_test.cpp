// The corrections for a sphere's own disturbance against hard spheres in disorder and the exact answer of a grid.
#include "solver/coupling/forces/disturbance_correction.hpp"

#include <algorithm>
#include <random>

#include "tests/verification/forces/oseen_grid.hpp"
#include "tests/verification/forces/vectors.hpp"

namespace slfb::coupling {
namespace {

/// Hard spheres of diameter 1 in a periodic cube, stirred by Metropolis moves from a face-centred lattice.
class HardSpheres {
 public:
  HardSpheres(int lattice, double solid_fraction) {
    const double number = 4.0 * lattice * lattice * lattice;
    side_ = std::cbrt(number * std::numbers::pi / 6.0 / solid_fraction);
    const double step = side_ / lattice;
    for (int i = 0; i < lattice; ++i)
      for (int j = 0; j < lattice; ++j)
        for (int k = 0; k < lattice; ++k)
          for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}})
            centres_.push_back({(i + x) * step, (j + y) * step, (k + z) * step});
  }

  void stir(int sweeps, double length, std::mt19937& random) {
    std::uniform_real_distribution<double> move(-length, length);
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t i = 0; i < centres_.size(); ++i) {
        std::array<double, 3> tried = centres_[i];
        for (double& x : tried) x += move(random);
        const bool free = std::ranges::all_of(centres_, [&](const auto& other) {
          double squared = 0.0;
          for (std::size_t a = 0; a < 3; ++a) {
            const double distance = tried[a] - other[a];
            squared += std::pow(distance - side_ * std::round(distance / side_), 2);
          }
          return squared >= 1.0 || &other == &centres_[i];
        });
        if (free) centres_[i] = tried;
      }
  }

  struct Means {
    double seen, corrected;
  };
  /// Voidage over all spheres, as gathered through the shares and as corrected, on cells of about `cell` diameters.
  [[nodiscard]] Means voidage(double cell) const {
    const int n = static_cast<int>(std::lround(side_ / cell));
    const double width = side_ / n;
    std::vector<double> solid(static_cast<std::size_t>(n) * n * n, 0.0);  // of a cell, in cell volumes
    const double own = std::numbers::pi / 6.0 / (width * width * width);
    const auto wrapped = [&](double index) {
      const int i = static_cast<int>(std::lround(index));
      return static_cast<std::size_t>((i % n + n) % n);
    };
    const auto place = [&](const std::array<double, 3>& c) {
      return (wrapped(c[0]) * static_cast<std::size_t>(n) + wrapped(c[1])) * static_cast<std::size_t>(n) +
             wrapped(c[2]);
    };
    std::vector<std::vector<OseenGrid::Share>> shares;
    for (const auto& c : centres_) {
      shares.push_back(OseenGrid::shares({c[0] / width, c[1] / width, c[2] / width}, 0.5 / width));
      for (const auto& [corner, share] : shares.back()) solid[place(corner)] += share * own;
    }
    Means means{};
    for (const auto& sphere : shares) {
      std::vector<double> parts;
      double seen = 1.0;
      for (const auto& [corner, share] : sphere) {
        seen -= share * solid[place(corner)];
        parts.push_back(share);
      }
      const std::vector<double> volumes(parts.size(), width * width * width);
      const double own_fraction = std::numbers::pi / 6.0 * share_concentration(parts, volumes);
      means.seen += seen / static_cast<double>(shares.size());
      means.corrected += undisturbed_voidage(seen, own_fraction) / static_cast<double>(shares.size());
    }
    return means;
  }

 private:
  double side_ = 0.0;
  std::vector<std::array<double, 3>> centres_;
};

TEST(UndisturbedVoidage, IsOneForALoneSphere) {
  for (const double own : {1e-3, 0.05, 0.3, 0.52}) EXPECT_NEAR(undisturbed_voidage(1.0 - own, own), 1.0, 1e-12) << own;
  // And a neighbour that comes into reach changes it little by little.
  EXPECT_NEAR(undisturbed_voidage(1.0 - 0.3 - 1e-4, 0.3), 1.0, 1e-3);
}

// A sphere much smaller than the cells changes nothing.
TEST(UndisturbedVoidage, LeavesSmallSpheresAlone) {
  for (const double voidage : {0.4, 0.7, 0.95}) EXPECT_NEAR(undisturbed_voidage(voidage, 1e-6), voidage, 1e-6);
}

// Spheres of a homogeneous suspension see its voidage on the mean, over cells of 1.2 to 3 diameters: within 0.012,
// where without correction it is short by up to 0.13.
TEST(UndisturbedVoidage, IsThatOfAHomogeneousSuspension) {
  std::mt19937 random(1);
  for (const double solid : {0.05, 0.2, 0.4, 0.5}) {
    HardSpheres spheres(4, solid);
    spheres.stir(150, 0.6 - solid, random);
    for (const double cell : {1.2, 1.6, 2.0, 3.0}) {
      HardSpheres::Means mean{};
      for (int k = 0; k < 4; ++k) {
        spheres.stir(20, 0.6 - solid, random);
        const auto now = spheres.voidage(cell);
        mean.seen += 0.25 * now.seen;
        mean.corrected += 0.25 * now.corrected;
      }
      EXPECT_NEAR(mean.corrected, 1.0 - solid, 0.012) << solid << " " << cell << " seen " << mean.seen;
    }
  }
}

// Oseen (1910): what a force F leaves less than in Stokes flow at its own place is F ρ U/(16 π μ²), whatever its width;
// without viscosity a Gaussian wake of half its length, F/(4 π ρ U σ²).
TEST(OseenWeakening, HasTheLimitsOfOseenAndOfTheInviscidWake) {
  const double width = 1.0, viscosity = 1.0, density = 1.0;
  const double stokes = std::sqrt(2.0 / std::numbers::pi) / (6.0 * std::numbers::pi * viscosity * width);
  for (const double speed : {1e-3, 0.019, 0.021}) {
    const double lost = stokes * (1.0 - oseen_weakening(density * speed * width / viscosity));
    EXPECT_NEAR(lost * 16.0 * std::numbers::pi / speed, 1.0, 0.5 * speed) << speed;
  }
  const double fast = 1e4;
  EXPECT_NEAR(stokes * oseen_weakening(fast) * 4.0 * std::numbers::pi * density * fast * width * width, 1.0, 1e-3);
}

// The reference itself: spread over a ball of many cells, a force moves the liquid there by the mean of the Stokeslet
// over the ball twice, (6/5) F/(6 π μ r), the 6/5 known from the energy of a charged ball; and the size of the periodic
// box drops out with Hasimoto's images.
TEST(OseenGrid, IsStokesFlowForABallOfManyCells) {
  const double radius = 4.0;
  const OseenGrid grid(32, 32), larger(48, 48);
  const double exact = 1.2 / (6.0 * std::numbers::pi * radius);
  EXPECT_NEAR(grid.response(OseenGrid::shares({16.0, 16.0, 16.0}, radius), 0.0) + grid.images(), exact, 0.03 * exact);
  const auto eight_cells = OseenGrid::shares({4.0, 4.0, 4.0}, 0.5);
  EXPECT_NEAR(grid.response(eight_cells, 0.0) + grid.images(), larger.response(eight_cells, 0.0) + larger.images(),
              1e-4);
}

/// Places of a sphere in its cell: on the centre, on a corner, on a face, and in between.
const std::vector<std::array<double, 3>> places{{4.5, 4.5, 4.5}, {4.0, 4.0, 4.0}, {4.0, 4.5, 4.5}, {4.5, 4.5, 4.0},
                                                {4.3, 4.4, 4.2}, {4.1, 4.7, 4.6}, {4.8, 4.2, 4.9}, {4.6, 4.0, 4.3}};

struct Deviation {
  double least = 1e9, most = -1e9, mean = 0.0;
};
/// Model over grid, less one.
template <class Model, class Grid>
Deviation deviation(double cell, Model model, Grid grid) {
  Deviation d;
  for (const auto& centre : places) {
    const auto shares = OseenGrid::shares(centre, 0.5 / cell);
    std::vector<double> parts;
    for (const auto& share : shares) parts.push_back(share.share);
    const double concentration = share_concentration(parts, std::vector<double>(parts.size(), 1.0));
    const double x = model(concentration) / grid(shares, concentration) - 1.0;
    d.least = std::min(d.least, x);
    d.most = std::max(d.most, x);
    d.mean += x / static_cast<double>(places.size());
  }
  return d;
}

// Measured: −18 to +12 %, in the mean of the places −4 to +3 %.
TEST(SelfInducedVelocity, SteadyStokesFlowOfTheGrid) {
  const OseenGrid grid(40, 40);
  const SelfInducedVelocity model({1.0, 1.0});
  for (const double cell : {0.7, 1.0, 1.6, 3.0, 10.0}) {
    const auto d = deviation(
        cell, [&](double concentration) { return model.mobility(concentration, 1.0, 0.0); },
        [&](const auto& shares, double) { return grid.response(shares, 0.0) + grid.images(); });
    EXPECT_GT(d.least, -0.2) << cell;
    EXPECT_LT(d.most, 0.15) << cell;
    EXPECT_NEAR(d.mean, 0.0, 0.06) << cell;
  }
}

// Measured at ρ U V_e^(1/3)/μ of 2 and 10: −30 to +19 %, means −5 to +4 %; at 50: −27 to +44 %, means +13 to +16 %.
TEST(SelfInducedVelocity, SteadyOseenFlowOfTheGrid) {
  const OseenGrid grid(192, 24);
  const SelfInducedVelocity model({1.0, 1.0});
  for (const double cell : {0.7, 1.6, 10.0})
    for (const auto& [reynolds, spread, mean] : {std::array{2.0, 0.35, 0.07}, {10.0, 0.35, 0.07}, {50.0, 0.5, 0.2}}) {
      const double speed = reynolds;
      const auto d = deviation(
          cell,
          [&](double concentration) { return model.mobility(concentration, 1.0, speed * std::cbrt(concentration)); },
          [&](const auto& shares, double concentration) {
            return grid.response(shares, speed * std::cbrt(concentration));
          });
      EXPECT_GT(d.least, -spread) << cell << " " << reynolds;
      EXPECT_LT(d.most, spread) << cell << " " << reynolds;
      EXPECT_NEAR(d.mean, 0.0, mean) << cell << " " << reynolds;
    }
}

// From rest under a constant force. Measured: at Re 50 −41 to +40 % (no worse at 10), means within 17 %. Without slip
// the exact approach is as t^−½ and the exponential one is ahead of it, by up to 60 % for a place, 45 % in the mean.
TEST(SelfInducedVelocity, GrowsAsOnTheGrid) {
  const SelfInducedVelocity model({1.0, 1.0});
  for (const double cell : {0.7, 1.6})
    for (const auto& [reynolds, least, most, mean] : {std::array{0.0, -0.25, 0.65, 0.5}, {50.0, -0.45, 0.45, 0.2}})
      for (const double part : {0.01, 0.5, 2.0}) {
        const OseenGrid grid(reynolds > 0.0 ? 96 : 32, reynolds > 0.0 ? 18 : 32);
        const double speed = reynolds, scaled = part / (1.0 + reynolds / 3.0);
        const auto time = [&](double concentration) { return scaled * std::pow(concentration, -2.0 / 3.0); };
        const auto d = deviation(
            cell,
            [&](double concentration) {
              return model
                  .advance({}, {1.0, 0.0, 0.0}, concentration, 1.0, speed * std::cbrt(concentration),
                           time(concentration))
                  .x;
            },
            [&](const auto& shares, double concentration) {
              return grid.response(shares, speed * std::cbrt(concentration), 0.01 * time(concentration), 100);
            });
        EXPECT_GT(d.least, least) << cell << " " << reynolds << " " << part;
        EXPECT_LT(d.most, most) << cell << " " << reynolds << " " << part;
        EXPECT_NEAR(d.mean, 0.0, mean) << cell << " " << reynolds << " " << part;
      }
}

// Any steps lead the same way under a constant force; without one the velocity dies away; the direction is the force's;
// half the liquid gives twice the velocity.
TEST(SelfInducedVelocity, StepsAndDirections) {
  const SelfInducedVelocity model({1000.0, 1e-3});
  const double concentration = 1.0 / std::pow(7e-3, 3);
  const Vec3 force{1e-4, -2e-4, 3e-4};
  const auto after = [&](Vec3 velocity, Vec3 f, int steps, double time_step) {
    for (int k = 0; k < steps; ++k) velocity = model.advance(velocity, f, concentration, 0.5, 0.05, time_step);
    return velocity;
  };
  const Vec3 once = after({}, force, 1, 0.1), many = after({}, force, 100, 1e-3);
  expect_near(once, many, 1e-12 * norm(once));
  EXPECT_NEAR(dot(once, force), norm(once) * norm(force), 1e-12 * norm(once) * norm(force));
  EXPECT_LT(norm(after(once, {}, 1, 10.0)), 1e-3 * norm(once));
  EXPECT_NEAR(model.mobility(concentration, 0.5, 0.05), 2.0 * model.mobility(concentration, 1.0, 0.05), 1e-9);
}

}  // namespace
}  // namespace slfb::coupling
