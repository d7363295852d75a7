// The exchange of momentum between spheres and liquid: no impulse is lost in any combination of schemes, stiff drag is
// stable and relaxes as it must, and the steps of the spheres within one of the liquid may be as many as one likes.
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/materials.hpp"
#include "tests/verification/coupled_cases.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {
namespace {

/// Spheres in a part of a box or column that fall, drift and shear, so that every force is there.
void fill(CoupledCase& bed, double spacing) {
  const auto& box = bed.scene.geometry;
  const double half = 0.5 * (box.shape == Shape::box ? box.width[0] : box.diameter);
  int k = 0;
  for (double z = 0.6 * spacing; z < 0.6 * box.height; z += spacing)
    for (double y = -half + 0.55 * spacing; y < half - 0.5 * spacing; y += spacing)
      for (double x = -half + 0.6 * spacing; x < half - 0.5 * spacing; x += spacing, ++k)
        bed.add({x + 1e-4 * std::sin(3.0 * k), y + 1e-4 * std::cos(5.0 * k), z},
                {0.02 * std::sin(1.7 * k), 0.03 * std::cos(2.3 * k), 0.05 * std::cos(3.0 * k)});
}

struct Impulse {
  std::array<double, 3> on_spheres{}, from_liquid{}, size{};
};

/// What the liquid does to the spheres over a step beyond buoyancy: by the motion of the spheres, from the engine's
/// momenta, and by what left the liquid, from its own momentum nodes: drag, and −∇p + ∇·τ on the volume that is not its
/// own. The two share neither loops nor fields.
Impulse impulse_of_step(CoupledCase& bed) {
  Impulse impulse;
  const auto before = bed.engine.particles.velocity;
  bed.exchange->advance(bed.engine, bed.scene.fluid.time_step);
  const auto& liquid = *bed.liquid;
  std::vector<double> solid = cell_volumes(liquid.grid()), full = solid;
  for (std::size_t c = 0; c < solid.size(); ++c) solid[c] -= bed.exchange->liquid_volume()[c];
  for (std::size_t a = 0; a < 3; ++a) {
    std::vector<double> nodes;
    liquid.scatter(a, solid, nodes);
    double stress = 0.0;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      stress += nodes[n] * (liquid.viscous_force(a)[n] - liquid.pressure_gradient(a)[n]);
    impulse.from_liquid[a] = bed.exchange->drag_taken_from_liquid(a) + stress;
  }
  bed.engine.advance(std::llround(bed.scene.fluid.time_step / bed.scene.contact.time_step));
  const auto& spheres = bed.engine.particles;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    EXPECT_EQ(bed.engine.contacts(i), 0);
    const double volume = spheres.volume(i), per_time = spheres.mass[i] / bed.scene.fluid.time_step;
    const std::array<double, 3> force{
        per_time * (spheres.velocity.x[i] - before.x[i]), per_time * (spheres.velocity.y[i] - before.y[i]),
        per_time * (spheres.velocity.z[i] - before.z[i]) +
            (spheres.mass[i] - bed.scene.liquid.density * volume) * gravitational_acceleration};
    for (std::size_t a = 0; a < 3; ++a) {
      impulse.on_spheres[a] += force[a];
      impulse.size[a] += std::abs(force[a]);
    }
  }
  return impulse;
}

class ImpulseBalance : public testing::TestWithParam<std::tuple<MomentumExchange, Interpolation, VoidFractionScheme>> {
};

// Whatever reads the liquid and spreads the force: what one phase gains the other loses, in every direction, to
// round-off (1e-10 of the sum of all forces; measured 3e-15 to 2e-13).
TEST_P(ImpulseBalance, IsExact) {
  for (const FluidTier tier : {FluidTier::one_dimensional, FluidTier::three_dimensional})
    for (const double smoothing : {0.0, 0.008}) {
      Scene scene = periodic_box(0.03, 0.06, 4, 0.06);
      scene.geometry.shape = Shape::cylinder;
      scene.geometry.diameter = 0.03;
      scene.fluid.wall = LateralBoundary::no_slip;
      scene.fluid.tier = tier;
      std::tie(scene.coupling.exchange, scene.coupling.interpolation, scene.coupling.void_fraction) = GetParam();
      scene.coupling.meshing_pieces = 200;
      scene.coupling.smoothing_length = smoothing;
      CoupledCase bed(scene);
      fill(bed, 0.0072);
      ASSERT_GT(bed.engine.particles.size(), 50u);
      for (int k = 0; k < 4; ++k) {
        const Impulse impulse = impulse_of_step(bed);
        // A column of single cells has no lateral velocity: what drags sideways is taken up by the walls.
        for (std::size_t a = tier == FluidTier::one_dimensional ? 2 : 0; a < 3; ++a) {
          ASSERT_GT(impulse.size[a], 0.0);
          EXPECT_NEAR(impulse.on_spheres[a], impulse.from_liquid[a], 1e-10 * impulse.size[a])
              << a << ", step " << k << ", smoothing " << smoothing << ", cells " << bed.liquid->grid().cells();
        }
      }
    }
}

constexpr std::array exchange_names{"explicit", "semi_implicit", "implicit"};
constexpr std::array interpolation_names{"_shares", "_gradient", "_trilinear"};
constexpr std::array void_fraction_names{"_centroid", "_meshing", "_exact"};

template <class Names, class Value>
std::string pick(const Names& names, Value value) {
  return names.at(static_cast<std::size_t>(value));
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, ImpulseBalance,
    testing::Combine(testing::Values(MomentumExchange::explicit_in_time, MomentumExchange::semi_implicit,
                                     MomentumExchange::implicit),
                     testing::Values(Interpolation::shares, Interpolation::gradient, Interpolation::trilinear),
                     testing::Values(VoidFractionScheme::centroid, VoidFractionScheme::particle_meshing,
                                     VoidFractionScheme::exact_overlap)),
    [](const auto& combination) {
      return pick(exchange_names, std::get<0>(combination.param)) +
             pick(interpolation_names, std::get<1>(combination.param)) +
             pick(void_fraction_names, std::get<2>(combination.param));
    });

/// Spheres of 10 µm on a face-centred lattice that fits the cells, so that every cell holds 0.6 solids, all drifting
/// sideways through liquid at rest; the places do not change. Along x nothing but drag acts.
struct DriftingLattice {
  static constexpr double diameter = 1e-5, solids = 0.6, speed = 1e-4, sphere_density = 2230.0;

  DriftingLattice(double stiffness, MomentumExchange scheme) : bed(scene_with(stiffness, scheme)) {
    const double a = unit();
    for (int k = 0; k < 10 * layers; ++k)
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
          for (const auto& [x, y, z] :
               {std::array{0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}})
            bed.add({(i - 1 + x) * a, (j - 1 + y) * a, (k + z) * a}, {speed, 0.0, 0.0});
  }

  static double unit() { return diameter * std::cbrt(4.0 * std::numbers::pi / 6.0 / solids); }
  /// β of creeping flow by Ergun's first term [kg/(m³ s)].
  static double beta() { return 150.0 * solids * solids * 1e-3 / ((1.0 - solids) * diameter * diameter); }
  static Scene scene_with(double stiffness, MomentumExchange scheme) {
    // Cells ten lattice units high: the inlet, at rest, drags along a thousandth of the momentum over the relaxation.
    Scene scene = periodic_box(2.0 * unit(), 10 * layers * unit(), 2, 0.0);
    scene.fluid.cell_height = 10.0 * unit();
    scene.species = {{"sphere", diameter, sphere_density, 1}};
    scene.coupling.drag_law = "ergun-1952";
    scene.coupling.exchange = scheme;
    scene.fluid.time_step = scene.contact.time_step = stiffness * scene.liquid.density / beta();
    scene.contact.stiffness = 1e-9;
    return scene;
  }

  void step() {
    const auto places = bed.engine.particles.position;
    bed.step();
    bed.engine.particles.position = places;
  }
  /// Mean velocity of the liquid along x, away from the ends, and of the spheres there.
  [[nodiscard]] std::pair<double, double> velocities() const {
    double liquid = 0.0, spheres = 0.0, n = 0.0;
    const auto& grid = bed.liquid->grid();
    const auto levels = static_cast<std::size_t>(grid.layers());
    const auto& u = bed.liquid->velocity(0);
    for (std::size_t s = 0; s < u.size() / levels; ++s)
      liquid += u[s * levels + levels / 2] / (static_cast<double>(u.size()) / static_cast<double>(levels));
    const double low = static_cast<double>(levels / 2) * grid.cell_height(), high = low + grid.cell_height();
    for (std::size_t i = 0; i < bed.engine.particles.size(); ++i) {
      const double z = bed.engine.particles.position.z[i];
      if (z < low || z > high) continue;
      spheres += bed.engine.particles.velocity.x[i];
      ++n;
    }
    return {liquid, spheres / n};
  }

  static constexpr int layers = 9;
  CoupledCase bed;
};

/// 1/ρ_L α + 1/ρ_S α_S over 1/ρ_L: what turns β Δt/ρ into the decay of the slip per step.
double rate_factor() {
  const double s = DriftingLattice::solids;
  return 1.0 / (1.0 - s) + 998.2 / (DriftingLattice::sphere_density * s);
}

// Eq. 35 with the liquid implicit too: the slip falls as an implicit Euler step of the two bodies does, at any
// stiffness, and ends in the common velocity that the conserved momentum gives.
TEST(StiffDrag, SemiImplicitAndImplicitRelaxToTheCommonVelocity) {
  const double s = DriftingLattice::solids, momentum = DriftingLattice::sphere_density * s * DriftingLattice::speed,
               common = momentum / (DriftingLattice::sphere_density * s + 998.2 * (1.0 - s));
  for (const MomentumExchange scheme : {MomentumExchange::semi_implicit, MomentumExchange::implicit})
    for (const double stiffness : {1e-2, 1e-1, 1.0, 10.0, 1e2, 1e3}) {
      DriftingLattice lattice(stiffness, scheme);
      double slip = DriftingLattice::speed;
      const int steps = std::max(60, static_cast<int>(std::ceil(10.0 / stiffness / rate_factor())));
      for (int k = 0; k < steps; ++k) {
        lattice.step();
        const auto [liquid, spheres] = lattice.velocities();
        const double now = spheres - liquid;
        // Down, and never through zero; 1e-4 of the start is what the inlet, at rest, does in the end.
        EXPECT_LE(now, slip + 1e-4 * DriftingLattice::speed) << stiffness << ", step " << k;
        EXPECT_GE(now, -1e-4 * DriftingLattice::speed) << stiffness << ", step " << k;
        if (k < 4) {
          EXPECT_NEAR(now, slip / (1.0 + stiffness * rate_factor()), 2e-3 * DriftingLattice::speed) << stiffness;
        }
        slip = now;
      }
      // Along z the spheres sink as slowly as the drag lets them, by U = 0 against a counterflow; nothing piles up.
      const double sinking = (DriftingLattice::sphere_density - 998.2) * gravitational_acceleration * s *
                             std::pow(1.0 - s, 2) / DriftingLattice::beta();
      double fastest = 0.0;
      for (const double v : lattice.bed.engine.particles.velocity.z) fastest = std::max(fastest, std::abs(v));
      EXPECT_LT(fastest, 1.01 * sinking / (1.0 - s)) << stiffness;
      const auto [liquid, spheres] = lattice.velocities();
      // The inlet, at rest, takes some of it: the more the longer the steps.
      EXPECT_NEAR(spheres, common, 1e-2 * common) << stiffness;
      EXPECT_NEAR(liquid, common, 1e-2 * common) << stiffness;
    }
}

// The explicit exchange multiplies the slip by 1 − β Δt (1/ρ_L α + 1/ρ_S α_S) a step: it decays up to the value 2 of
// that product, and grows without bound beyond.
TEST(StiffDrag, ExplicitBlowsUpBeyondItsLimit) {
  const double limit = 2.0 / rate_factor();
  const auto slip_after = [&](double stiffness, int steps) {
    DriftingLattice lattice(stiffness, MomentumExchange::explicit_in_time);
    for (int k = 0; k < steps; ++k) lattice.step();
    const auto [liquid, spheres] = lattice.velocities();
    return (spheres - liquid) / DriftingLattice::speed;
  };
  for (const double part : {0.25, 0.9, 1.1}) {
    const double factor = 1.0 - 2.0 * part;
    EXPECT_NEAR(slip_after(part * limit, 3), std::pow(factor, 3), 5e-3) << part;
  }
  EXPECT_LT(std::abs(slip_after(0.9 * limit, 12)), 0.1);
  EXPECT_GT(std::abs(slip_after(1.1 * limit, 12)), 5.0);
}

/// A few spheres and a liquid that is so viscous that every law is linear, or not.
std::unique_ptr<CoupledCase> few_spheres(MomentumExchange scheme, double viscosity) {
  Scene scene = periodic_box(0.03, 0.06, 4, 0.05);
  scene.liquid.viscosity = viscosity;
  scene.coupling.exchange = scheme;
  scene.coupling.drag_law = "wen-yu-1966";
  auto bed = std::make_unique<CoupledCase>(scene);
  fill(*bed, 0.0072);
  return bed;
}

// A linear law has the same coefficient at the new slip: the iteration has nothing to do, and both schemes are one.
TEST(ImplicitExchange, IsTheSemiImplicitOneForALinearLaw) {
  auto once = few_spheres(MomentumExchange::semi_implicit, 1e6);
  auto iterated = few_spheres(MomentumExchange::implicit, 1e6);
  for (int k = 0; k < 3; ++k) {
    once->step();
    iterated->step();
    EXPECT_LE(iterated->exchange->passes(), k == 0 ? 2 : 2);
  }
  double scale = 0.0;
  for (std::size_t i = 0; i < once->engine.particles.size(); ++i)
    scale = std::max(scale, std::abs(once->engine.particles.velocity.z[i]));
  for (std::size_t i = 0; i < once->engine.particles.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_NEAR(once->engine.particles.velocity.at(i)[a], iterated->engine.particles.velocity.at(i)[a], 1e-6 * scale);
}

// Where the law is not linear the iterated drag is the law's own at the slip that comes out of the step, to the
// tolerance of the iteration; the semi-implicit one is off by a first-order amount.
TEST(ImplicitExchange, TakesTheLawAtTheNewSlip) {
  const auto defect = [](MomentumExchange scheme) {
    auto bed = few_spheres(scheme, 1e-3);
    // A quick change of the slip within the step: spheres that have been thrown.
    for (double& v : bed->engine.particles.velocity.z) v -= 0.3;
    bed->step();
    double largest = 0.0;
    for (std::size_t i = 0; i < bed->engine.particles.size(); ++i) {
      const auto v = bed->engine.particles.velocity.at(i);
      double squared = 0.0;
      for (std::size_t a = 0; a < 3; ++a) squared += std::pow(bed->exchange->liquid_velocity(i, a) - v[a], 2);
      const double d = 2.0 * bed->engine.particles.radius[i], voidage = bed->exchange->voidage(i),
                   slip = std::sqrt(squared);
      const double law = drag::WenYu1966{}({voidage, 998.2 * d * voidage * slip / 1e-3});
      const double force =
          bed->engine.particles.volume(i) * slip * drag::exchange_per_solid_volume(law, voidage, d, 1e-3);
      double drag = 0.0;
      for (std::size_t a = 0; a < 3; ++a) drag += std::pow(bed->exchange->drag_force(i, a), 2);
      largest = std::max(largest, std::abs(std::sqrt(drag) / force - 1.0));
    }
    return largest;
  };
  EXPECT_LT(defect(MomentumExchange::implicit), 1e-5);
  EXPECT_GT(defect(MomentumExchange::semi_implicit), 1e-2);
}

// The liquid's force is constant over its step: free spheres have the same velocities after it however many steps they
// make of it, and with the Verlet scheme the same places; symplectic Euler is off by less than a Δt²/2 for each.
TEST(SubCycling, OfFreeSpheresIsExact) {
  const auto after = [](int substeps, Integrator integrator) {
    Scene scene = periodic_box(0.03, 0.06, 4, 0.06);
    scene.contact.time_step = scene.fluid.time_step / substeps;
    scene.contact.integrator = integrator;
    auto bed = std::make_unique<CoupledCase>(scene);
    fill(*bed, 0.0072);
    bed->step();
    return bed->engine.particles;
  };
  const auto reference = after(1, Integrator::velocity_verlet);
  for (const int substeps : {2, 7, 20}) {
    const auto verlet = after(substeps, Integrator::velocity_verlet),
               euler = after(substeps, Integrator::symplectic_euler);
    for (std::size_t i = 0; i < reference.size(); ++i)
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(verlet.velocity.at(i)[a], reference.velocity.at(i)[a], 1e-14);
        EXPECT_NEAR(euler.velocity.at(i)[a], reference.velocity.at(i)[a], 1e-14);
        EXPECT_NEAR(verlet.position.at(i)[a], reference.position.at(i)[a], 1e-16);
        EXPECT_NEAR(euler.position.at(i)[a], reference.position.at(i)[a], 0.5 * 20.0 * 1e-6);
      }
  }
}

// A frictional bed at rest below U_mf: contacts and drag carry it whatever the ratio of the steps is, to 1e-3
// of the pressure drop: it comes to rest in slightly different places.
TEST(SubCycling, LeavesABedAtRestAsItIs) {
  std::vector<double> drop;
  for (const int substeps : {1, 2, 7, 20}) {
    Scene scene = periodic_box(0.02, 0.05, 3, 0.02);
    scene.fluid.tier = FluidTier::one_dimensional;
    scene.fluid.cell_height = 0.00625;
    scene.fluid.wall = LateralBoundary::slip;
    scene.contact.stiffness = 200.0;
    scene.contact.restitution = 0.3;
    scene.fluid.time_step = 2e-4;
    scene.contact.time_step = scene.fluid.time_step / substeps;
    CoupledCase bed(scene, dem::walls_of(scene));
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) bed.add({(i - 1) * 0.0055, (j - 1) * 0.0055, 0.0025 + k * 0.005});
    bed.run(0.4);
    drop.push_back(bed.liquid->inlet_pressure());
  }
  for (const double d : drop) EXPECT_NEAR(d, drop.front(), 1e-3 * drop.front());
}

}  // namespace
}  // namespace slfb
