// What the particle engine counts and averages: collisions, their frequency against kinetic theory, the forces of a
// packed bed, fluctuating energy; and that all of it is the same whatever the threads, the numbering and the stops.
#include "solver/dem/collision_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>

#include "correlations/collision/collision_laws.hpp"
#include "correlations/materials.hpp"
#include "experiments/numerics/kinetic_theory/periodic_gas.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/granular_temperature.hpp"
#include "solver/dem/packing.hpp"
#include "solver/laws/make_engine.hpp"

namespace slfb::dem {
namespace {

constexpr double radius = 0.0025, density = 2230.0;
const double mass = density * Particles::volume_of(radius);

/// Uniform in (−1, 1), variance 1/3, the same on every machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : bits_(seed) {}
  double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-52 - 1.0; }
  Vec3 vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  std::mt19937_64 bits_;
};

void set(VectorField& field, std::size_t i, Vec3 value) {
  field.x[i] = value.x;
  field.y[i] = value.y;
  field.z[i] = value.z;
}

// --- fluctuating energy ----------------------------------------------------------------------------------------------

constexpr double noise = 0.02;                        ///< half width of the uniform velocities [m/s]
constexpr double noise_energy = 0.5 * noise * noise;  ///< q_p² = 3/2 · noise²/3
const auto resting = [](Vec3) { return Vec3{}; };

/// Points uniform in a cube of edge 0.1 m around the origin, with random velocities on a mean flow.
Particles noisy_flow(std::size_t count, std::uint64_t seed, const std::function<Vec3(Vec3)>& flow) {
  Uniform uniform(seed);
  Particles particles;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 x = 0.05 * uniform.vector();
    particles.add({x.x, x.y, x.z}, radius, density, 0);
    set(particles.velocity, i, noise * uniform.vector() + flow(x));
  }
  return particles;
}

TEST(FluctuatingEnergy, IgnoresATranslation) {
  const auto still = noisy_flow(2000, 1, resting);
  const auto carried = noisy_flow(2000, 1, [](Vec3) { return Vec3{3.0, -2.0, 5.0}; });
  EXPECT_NEAR(fluctuating_energy(carried), fluctuating_energy(still), 1e-10 * noise_energy);
  const std::array<double, 3> box{0.02, 0.02, 0.02};
  EXPECT_NEAR(local_fluctuating_energy(carried, box), local_fluctuating_energy(still, box), 1e-10 * noise_energy);
}

// What is left of a gradient falls with the square of the edge: γ²h²/24 of a shear, ω²h²/12 of a rotation.
TEST(FluctuatingEnergy, LocalOneRemovesShearAndRotationToSecondOrder) {
  const double rate = 2.0;
  const auto shear = noisy_flow(40000, 2, [&](Vec3 x) { return Vec3{rate * x.y, 0, 0}; });
  const auto rotation = noisy_flow(40000, 2, [&](Vec3 x) { return Vec3{-rate * x.y, rate * x.x, 0}; });
  const auto still = noisy_flow(40000, 2, resting);
  for (double h : {0.05, 0.025, 0.0125, 0.00625}) {
    const double left = rate * rate * h * h / 24.0, noise_left = local_fluctuating_energy(still, {h, h, h});
    const double tolerance = 0.02 * left + 0.002 * noise_energy;  // the flow and 40000 random velocities correlate
    EXPECT_NEAR(local_fluctuating_energy(shear, {h, h, h}) - noise_left, left, tolerance) << h;
    EXPECT_NEAR(local_fluctuating_energy(rotation, {h, h, h}) - noise_left, 2.0 * left, 2.0 * tolerance) << h;
  }
  EXPECT_GT(fluctuating_energy(shear), 5.0 * noise_energy);
  EXPECT_GT(fluctuating_energy(rotation), 5.0 * noise_energy);
  // Layers across the shear do as well as boxes.
  EXPECT_NEAR(local_fluctuating_energy(shear, {0, 0.00625, 0}), noise_energy, 0.03 * noise_energy);
}

// One to three spheres per box: dividing by n instead of n − 1 would lose about half.
TEST(FluctuatingEnergy, IsUnbiasedInSmallBoxes) {
  const std::array<double, 3> box{0.01, 0.01, 0.01};
  const int samples = 200;
  double local = 0.0, global = 0.0;
  for (std::uint64_t sample = 0; sample < samples; ++sample) {
    local += local_fluctuating_energy(noisy_flow(1500, 10 + sample, resting), box) / samples;
    global += fluctuating_energy(noisy_flow(3, 10 + sample, resting)) / samples;
  }
  EXPECT_NEAR(local, noise_energy, 0.005 * noise_energy);
  EXPECT_NEAR(global, noise_energy, 0.15 * noise_energy);
}

TEST(FluctuatingEnergy, LeavesTheExcludedSphereOut) {
  auto particles = noisy_flow(500, 3, resting);
  const double expected = fluctuating_energy(particles);
  const std::size_t foreign = particles.add({0, 0, 0}, 2.0 * radius, 7800.0, 1);
  particles.velocity.z[foreign] = -100.0;
  EXPECT_DOUBLE_EQ(fluctuating_energy(particles, foreign), expected);
  EXPECT_GT(fluctuating_energy(particles), 100.0 * expected);
  EXPECT_LT(local_fluctuating_energy(particles, {0.05, 0.05, 0.05}, foreign), 1.1 * expected);

  Particles alone;
  alone.add({0, 0, 0}, radius, density, 0);
  EXPECT_EQ(fluctuating_energy(alone), 0.0);
  EXPECT_EQ(fluctuating_energy(alone, 0), 0.0);
}

// --- single collisions -----------------------------------------------------------------------------------------------

constexpr double approach = 0.1;  ///< [m/s]

Contact linear(double restitution, int steps_per_contact, double stiffness = 1e4) {
  Contact contact;
  contact.stiffness = stiffness;
  contact.restitution = restitution;
  contact.sliding_friction = 0.0;
  contact.time_step = LinearSpringDashpot::contact_time(stiffness, restitution, 0.5 * mass) / steps_per_contact;
  return contact;
}

/// Spheres 0 and 1 about to collide on the x axis, in the corner of cells that many others could share.
void add_pair(Engine& engine) {
  for (double side : {-1.0, 1.0}) {
    const std::size_t i = engine.add_particle({side * 1.001 * radius, 0, 0}, radius, density, 0);
    engine.particles.velocity.x[i] = -side * 0.5 * approach;
  }
}

TEST(SingleCollision, TellsItsDurationAndSpeed) {
  for (double restitution : {0.5, 0.9, 1.0}) {
    Engine engine = make_engine(linear(restitution, 200), {}, {0, 0, 0}, 1);
    engine.collect_collisions(true);
    add_pair(engine);
    const std::size_t idle = engine.add_particle({0, 2.2 * radius, 0}, radius, density, 0);
    const std::int64_t before = 20;
    engine.advance(before);
    EXPECT_EQ(engine.contact_events(0), 0);
    engine.advance(100);
    EXPECT_EQ(engine.contacts(0), 1);
    EXPECT_TRUE(engine.take_collisions().empty()) << "not finished yet";
    engine.advance(500);

    const auto collisions = engine.take_collisions();
    ASSERT_EQ(collisions.size(), 1u);
    EXPECT_EQ(collisions[0].first, 0u);
    EXPECT_EQ(collisions[0].second, 1u);
    EXPECT_NEAR(collisions[0].steps, 200, 1);
    EXPECT_NEAR(collisions[0].impact_speed, approach, 1e-12);
    const double start = 2.0 * 0.001 * radius / approach / engine.time_step();  // steps until they touch
    EXPECT_NEAR(static_cast<double>(collisions[0].end_step), start + 200, 3);
    EXPECT_TRUE(engine.take_collisions().empty()) << "told once";

    EXPECT_EQ(engine.contact_events(0), 1);
    EXPECT_EQ(engine.contact_events(1), 1);
    EXPECT_EQ(engine.contact_events(idle), 0);
    EXPECT_EQ(engine.particles.position.at(idle), (std::array<double, 3>{0, 2.2 * radius, 0}));
    EXPECT_EQ(engine.particles.velocity.at(idle), (std::array<double, 3>{0, 0, 0}));
  }
}

// A fast third sphere far off has the list rebuilt and the order of the cells changed all the time.
TEST(SingleCollision, IsOneEpisodeWhateverTheList) {
  for (int threads : {1, 3}) {
    Engine engine = make_engine(linear(0.9, 200), {}, {0, 0, 0}, threads);
    engine.collect_collisions(true);
    const std::size_t passer = engine.add_particle({0, 20 * radius, -200 * radius}, radius, density, 0);
    engine.particles.velocity.z[passer] = 20.0;
    add_pair(engine);  // numbers 1 and 2
    const std::int64_t builds = engine.list_builds();
    engine.advance(120);
    EXPECT_EQ(engine.contacts(1), 1);
    EXPECT_GT(engine.list_builds(), builds + 4);
    engine.advance(20000);  // the passer has changed the order, too
    EXPECT_EQ(engine.contact_events(1), 1);
    EXPECT_EQ(engine.contact_events(2), 1);
    EXPECT_EQ(engine.contact_events(passer), 0);
    const auto collisions = engine.take_collisions();
    ASSERT_EQ(collisions.size(), 1u);
    EXPECT_EQ(collisions[0].first, 1u);
    EXPECT_EQ(collisions[0].second, 2u);
    EXPECT_NEAR(collisions[0].steps, 200, 1);
    EXPECT_NEAR(collisions[0].impact_speed, approach, 1e-12);
  }
}

// The list numbers its spheres anew between the end of the collision and its telling.
TEST(SingleCollision, IsRecordedForTheRightSpheres) {
  Engine engine = make_engine(linear(0.9, 50), {}, {0, 0, 0}, 1);
  engine.collect_collisions(true);
  const std::size_t mover = engine.add_particle({0, 0, -20 * radius}, radius, density, 0);
  add_pair(engine);
  engine.advance(70);
  engine.particles.position.z[mover] = 20 * radius;  // from the first place in the order to the last
  engine.advance(1);
  const auto collisions = engine.take_collisions();
  ASSERT_EQ(collisions.size(), 1u);
  EXPECT_EQ(collisions[0].first, 1u);
  EXPECT_EQ(collisions[0].second, 2u);
}

TEST(SingleCollision, IsToldAlthoughASphereWasAddedOrRemoved) {
  Engine engine = make_engine(linear(0.9, 50), {}, {0, 0, 0}, 1);
  engine.collect_collisions(true);
  add_pair(engine);
  engine.advance(70);  // parted, but still in the list
  const std::size_t third = engine.add_particle({0, 20 * radius, 0}, radius, density, 0);
  EXPECT_EQ(engine.take_collisions().size(), 1u);

  engine.particles.velocity.x[0] = 0.5 * approach;
  engine.particles.velocity.x[1] = -0.5 * approach;
  engine.advance(80);
  engine.remove_particle(third);
  EXPECT_EQ(engine.contact_events(0), 2);
  EXPECT_EQ(engine.contacts(0), 0);
  EXPECT_EQ(engine.take_collisions().size(), 1u);
}

TEST(SingleCollision, BeforeCollectingIsNotTold) {
  Engine engine = make_engine(linear(0.9, 50), {}, {0, 0, 0}, 1);
  add_pair(engine);
  engine.advance(70);
  ASSERT_EQ(engine.contact_events(0), 1);
  ASSERT_EQ(engine.contacts(0), 0);
  engine.collect_collisions(true);
  EXPECT_TRUE(engine.take_collisions().empty());
}

// --- frequency -------------------------------------------------------------------------------------------------------

double kinetic_theory(double solids, double contact_value) {
  return collision::Simonin1991{}({solids, 1.0, 1.0, 1.0, 0.0, contact_value});
}

class CollisionFrequency : public testing::TestWithParam<double> {};

TEST_P(CollisionFrequency, IsThatOfKineticTheory) {
  const double solids = GetParam();
  const kinetic::MeasuredFrequency measured = kinetic::measure_frequency(solids, 10, 32.0);
  const double expected = kinetic_theory(solids, collision::CarnahanStarling1969{}(solids));
  EXPECT_NEAR(measured.value, expected, 0.03 * expected);
  EXPECT_LT(measured.error, 0.015 * expected);
  EXPECT_LT(measured.contact_fraction, 0.005);
  EXPECT_LT(measured.energy_change, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Solids, CollisionFrequency, testing::Values(0.05, 0.25, 0.45));

// Every contact that has begun is running or was told; but for spheres that graze each other within one step, which
// recede already when they are first seen to touch.
TEST(CollisionCount, AddsUpOverManySpheres) {
  for (int threads : {1, 3}) {
    const double length = 0.05;
    Engine engine = make_engine(linear(0.95, 20), {}, {length, length, length}, threads);
    engine.collect_collisions(true);
    Uniform uniform(7);
    for (int k = 0; k < 512; ++k) {
      const auto site = [&](int a) { return (a + 0.5) * length / 8 - 0.5 * length; };
      const std::size_t i = engine.add_particle({site(k % 8), site(k / 8 % 8), site(k / 64)}, radius, density, 0);
      set(engine.particles.velocity, i, 0.5 * uniform.vector());
    }
    std::vector<std::int64_t> told(512, 0);
    std::int64_t collisions = 0;
    for (int k = 0; k < 10; ++k) {
      engine.advance(2000);
      for (const Collision& collision : engine.take_collisions()) {
        ++told[collision.first];
        ++told[collision.second];
        ++collisions;
        EXPECT_GE(collision.impact_speed, 0.0);
      }
    }
    std::int64_t untold = 0;
    for (std::size_t i = 0; i < 512; ++i) {
      const std::int64_t missing = engine.contact_events(i) - engine.contacts(i) - told[i];
      EXPECT_GE(missing, 0) << i;
      untold += std::abs(missing);
    }
    EXPECT_GT(collisions, 3000);
    EXPECT_LE(untold, collisions / 500);
  }
}

// --- a bed at rest ---------------------------------------------------------------------------------------------------

Scene column(std::int64_t count) {
  Scene scene;
  scene.geometry.diameter = 0.05;
  scene.geometry.height = 0.2;
  scene.species = {{"glass", 2.0 * radius, density, count}};
  return scene;
}

void set_gravity(Engine& engine, double times = 1.0) {
  engine.external_force.set_zero();
  for (std::size_t i = 0; i < engine.particles.size(); ++i)
    engine.external_force.z[i] = -times * engine.particles.mass[i] * gravitational_acceleration;
}

/// Volume of a sphere below a height.
double volume_below(double centre, double height) {
  const double h = std::clamp(height - centre + radius, 0.0, 2.0 * radius);
  return std::numbers::pi * h * h * (radius - h / 3.0);
}

struct PackedBed {
  Engine engine;
  double weight, bottom_force, wall_force, voidage, coordination;
};

PackedBed settle(double friction, double duration) {
  Contact contact = linear(0.5, 20, 1e3);
  contact.sliding_friction = friction;
  const Scene scene = column(600);
  Engine engine = make_engine(contact, walls_of(scene), {0, 0, 0}, 1);
  for (const PlacedSphere& sphere : start_positions(scene)) engine.add_particle(sphere.centre, radius, density, 0);
  set_gravity(engine);
  engine.advance(static_cast<std::int64_t>(duration / contact.time_step));

  PackedBed bed{std::move(engine), 600 * mass * gravitational_acceleration, 0.0, 0.0, 0.0, 0.0};
  for (const auto& pair : bed.engine.touching_pairs())
    if (pair.at_wall && pair.second == 0) bed.bottom_force += pair.normal_force;
  double solids = 0.0;
  const double low = 2.0 * radius, high = 0.025;
  for (std::size_t i = 0; i < 600; ++i) {
    bed.wall_force += bed.engine.wall_force(i)[2];
    bed.coordination += bed.engine.contacts(i) / 600.0;
    const double z = bed.engine.particles.position.z[i];
    solids += volume_below(z, high) - volume_below(z, low);
  }
  bed.voidage = 1.0 - solids / (0.25 * std::numbers::pi * 0.05 * 0.05 * (high - low));
  return bed;
}

/// Gershgorin: twice the stiffness of all contacts of a sphere over its mass, where it is largest.
void expect_sane_network_frequency(const Engine& engine) {
  std::vector<int> contacts(engine.particles.size(), 0);
  for (const auto& pair : engine.touching_pairs()) {
    ++contacts[pair.first];
    if (!pair.at_wall) ++contacts[pair.second];
  }
  const int most = *std::max_element(contacts.begin(), contacts.end());
  EXPECT_GE(most, 6);
  EXPECT_LE(most, 12);
  EXPECT_NEAR(engine.network_frequency_squared(), 2.0 * most * 1e3 / mass, 1e-9 * most * 1e3 / mass);
}

TEST(BedAtRest, IsCarriedByBottomAndWall) {
  const PackedBed bed = settle(0.3, 1.0);
  EXPECT_NEAR(bed.wall_force, bed.weight, 1e-3 * bed.weight);
  EXPECT_LT(bed.bottom_force, 0.99 * bed.weight) << "the wall carries a share (Janssen)";
  EXPECT_GT(bed.bottom_force, 0.7 * bed.weight);
  EXPECT_GT(bed.voidage, 0.38);
  EXPECT_LT(bed.voidage, 0.46);
  EXPECT_GT(bed.coordination, 4.0);
  EXPECT_LT(bed.coordination, 6.0);
  expect_sane_network_frequency(bed.engine);
  // Newton's third law: what the spheres do to each other adds up to nothing.
  std::array<double, 3> inner{};
  for (std::size_t i = 0; i < 600; ++i)
    for (std::size_t a = 0; a < 3; ++a) inner[a] += bed.engine.contact_force(i)[a];
  for (double sum : inner) EXPECT_NEAR(sum, 0.0, 1e-12 * bed.weight);
}

TEST(BedAtRest, WithoutFrictionStandsOnItsBottom) {
  const PackedBed bed = settle(0.0, 2.0);
  EXPECT_NEAR(bed.bottom_force, bed.weight, 1e-3 * bed.weight);
  EXPECT_NEAR(bed.wall_force, bed.bottom_force, 1e-12 * bed.weight);
  for (std::size_t i = 0; i < 600; ++i)
    if (!bed.engine.touches_wall(i, 0)) {
      EXPECT_EQ(bed.engine.wall_force(i)[2], 0.0) << i;
    }
  EXPECT_GT(bed.voidage, 0.36);
  EXPECT_LT(bed.voidage, 0.43);
  EXPECT_GT(bed.coordination, 4.5);
  EXPECT_LT(bed.coordination, 6.2);
  expect_sane_network_frequency(bed.engine);
}

// --- the same bits ---------------------------------------------------------------------------------------------------

/// An agitated bed under five times gravity, which makes it dense soon, so that spheres have many contacts at once:
/// 240 spheres and among them a foreign one more than twice as large.
struct Agitated {
  Contact contact;
  std::vector<Wall> walls;
  std::array<double, 3> period{};

  /// The foreign sphere, number 0, and 240 others.
  [[nodiscard]] Particles start() const {
    Particles all;
    all.add({0.0005, -0.0003, 0.016}, 2.2 * radius, 7800.0, 1);
    Uniform uniform(5);
    for (int layer = 0; all.size() < 241; ++layer)
      for (int k = 0; k < 36 && all.size() < 241; ++k) {
        const Vec3 site{(k % 6 - 2.5) * 0.0056, (std::floor(k / 6.0) - 2.5) * 0.0056, 0.0035 + layer * 0.0056};
        const Vec3 x = site + 2e-4 * uniform.vector(), u = 0.5 * uniform.vector(), w = 50.0 * uniform.vector();
        if (norm(x - Vec3{0.0005, -0.0003, 0.016}) < 3.3 * radius || std::hypot(x.x, x.y) > 0.0172) continue;
        const std::size_t i = all.add({x.x, x.y, x.z}, radius, density, 0);
        set(all.velocity, i, u);
        set(all.angular_velocity, i, w);
      }
    return all;
  }

  /// With the spheres of start() in the given order.
  [[nodiscard]] Engine engine(int threads, const std::vector<std::size_t>& order) const {
    Engine made = make_engine(contact, walls, period, threads);
    const Particles all = start();
    for (std::size_t i : order) {
      const std::size_t k =
          made.add_particle(all.position.at(i), all.radius[i], i == 0 ? 7800.0 : density, all.species[i]);
      const auto u = all.velocity.at(i), w = all.angular_velocity.at(i);
      set(made.particles.velocity, k, {u[0], u[1], u[2]});
      set(made.particles.angular_velocity, k, {w[0], w[1], w[2]});
    }
    set_gravity(made, 5.0);
    return made;
  }
};

std::vector<std::size_t> as_numbered(std::size_t n) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<std::pair<std::string, Agitated>> agitated_beds() {
  Contact contact = linear(0.9, 20, 1e3);
  contact.sliding_friction = 0.3;
  contact.rolling_friction = 0.0175;
  contact.youngs_modulus = 1e7;
  const std::vector<Wall> bottom{{Wall::Kind::plane, 2, 1.0, 0.0}};
  std::vector<Wall> cylinder = bottom;
  cylinder.push_back({Wall::Kind::cylinder, 0, 1.0, 0.02});
  std::vector<std::pair<std::string, Agitated>> beds;
  const auto add = [&](const char* name, Integrator integrator, RollingModel rolling, const std::string& law,
                       bool periodic) {
    contact.integrator = integrator;
    contact.rolling_model = rolling;
    contact.law = law;
    beds.push_back({name,
                    {contact, periodic ? bottom : cylinder,
                     periodic ? std::array{0.036, 0.036, 0.0} : std::array{0.0, 0.0, 0.0}}});
  };
  constexpr auto torque = RollingModel::constant_torque, spring = RollingModel::elastic_plastic;
  add("Euler", Integrator::symplectic_euler, torque, "linear", false);
  add("Euler, periodic", Integrator::symplectic_euler, torque, "linear", true);
  add("velocity Verlet, rolling springs", Integrator::velocity_verlet, spring, "linear", false);
  add("position Verlet, rolling springs, periodic", Integrator::position_verlet, spring, "linear", true);
  add("Gear", Integrator::gear, torque, "linear", false);
  add("Hertz, Gear, rolling springs, periodic", Integrator::gear, spring, "hertz", true);
  return beds;
}

/// All that an engine knows of its spheres, bit by bit, in the order of start(): order[k] is the sphere of number k.
std::vector<std::uint64_t> bits(const Engine& engine, const std::vector<std::size_t>& order) {
  std::vector<std::size_t> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = k;
  std::vector<std::uint64_t> all;
  const Particles& p = engine.particles;
  for (std::size_t k : number) {
    for (const auto& vector : {p.position.at(k), p.velocity.at(k), p.angular_velocity.at(k), engine.mean_solid_force(k),
                               engine.contact_force(k), engine.wall_force(k)})
      for (double component : vector) all.push_back(std::bit_cast<std::uint64_t>(component));
    all.push_back(static_cast<std::uint64_t>(engine.contact_events(k)));
    all.push_back(static_cast<std::uint64_t>(engine.contacts(k)));
  }
  return all;
}
std::vector<std::uint64_t> bits(const Engine& engine) { return bits(engine, as_numbered(engine.particles.size())); }

TEST(SameBits, AtAnyNumberOfThreadsAndFromRunToRun) {
  for (const auto& [name, bed] : agitated_beds()) {
    // Threads are slow where there are fewer cores than threads: the long way only for one of them and one bed.
    std::vector<std::uint64_t> early, late;
    for (int threads : {1, 1, 2, 3, 5}) {
      Engine engine = bed.engine(threads, as_numbered(241));
      engine.advance(400);
      if (early.empty()) early = bits(engine);
      EXPECT_TRUE(bits(engine) == early) << name << ", " << threads << " threads, step 400";
      if (threads > 1 && !(threads == 3 && name == "Euler")) continue;
      engine.advance(1600);
      ASSERT_GT(engine.list_builds(), 5);
      std::size_t in_contact = 0;
      for (std::size_t i = 0; i < 241; ++i) in_contact += engine.contacts(i) > 1 ? 1 : 0;
      ASSERT_GT(in_contact, 120u) << name << ": a gas would not see the order of sums";
      if (late.empty()) late = bits(engine);
      EXPECT_TRUE(bits(engine) == late) << name << ", " << threads << " threads, step 2000";
    }
  }
}

TEST(SameBits, HoweverTheSpheresAreNumbered) {
  for (const auto& [name, bed] : agitated_beds()) {
    std::vector<std::size_t> order = as_numbered(241), backwards(order.rbegin(), order.rend()), mixed(order);
    for (std::size_t k = 0; k < 241; ++k) mixed[k] = k * 100 % 241;
    Engine engine = bed.engine(1, order);
    engine.advance(2000);
    for (const auto& other_order : {backwards, mixed}) {
      Engine other = bed.engine(1, other_order);
      other.advance(2000);
      EXPECT_TRUE(bits(other, other_order) == bits(engine, order)) << name;
    }
  }
}

using Calls = std::vector<std::function<void(Engine&)>>;

/// Some steps in each of many calls, spheres that come and go in between.
Calls many_calls() {
  Calls calls;
  for (int k = 0; k < 60; ++k) {
    calls.push_back([k](Engine& engine) { engine.advance(7 + 13 * k % 40); });
    if (k % 20 == 7)
      calls.push_back([](Engine& engine) {
        const std::size_t i = engine.add_particle({0.001, 0.002, 0.06}, 1.2 * radius, 7800.0, 1);
        engine.particles.velocity.z[i] = -1.0;
        set_gravity(engine, 5.0);
      });
    if (k % 20 == 15) calls.push_back([](Engine& engine) { engine.remove_particle(engine.particles.size() / 2); });
  }
  return calls;
}

TEST(SameBits, AfterAStopAtAnyCall) {
  const Calls calls = many_calls();
  for (const auto& [name, bed] : agitated_beds()) {
    Engine whole = bed.engine(1, as_numbered(241));
    for (const auto& call : calls) call(whole);
    for (std::size_t stride : {1u, 7u}) {
      auto engine = std::make_unique<Engine>(bed.engine(1, as_numbered(241)));
      for (std::size_t k = 0; k < calls.size(); ++k) {
        if (k % stride == 0) {
          auto resumed = std::make_unique<Engine>(make_engine(bed.contact, bed.walls, bed.period, k % 10 == 0 ? 3 : 1));
          resumed->restore(engine->particles, engine->memory());
          set_gravity(*resumed, 5.0);
          engine = std::move(resumed);
        }
        calls[k](*engine);
      }
      EXPECT_EQ(engine->steps(), whole.steps());
      EXPECT_TRUE(bits(*engine) == bits(whole)) << name << ", stopped before every call number k * " << stride;
    }
  }
}

// The mean force belongs to a call; the motion does not depend on how the steps are spread over calls.
TEST(SameBits, HoweverTheStepsAreSpreadOverCalls) {
  for (const auto& [name, bed] : agitated_beds()) {
    Engine once = bed.engine(1, as_numbered(241)), often = bed.engine(1, as_numbered(241));
    once.advance(2000);
    for (int k = 0; k < 2000; ++k) often.step();
    EXPECT_EQ(once.particles.position.x, often.particles.position.x) << name;
    EXPECT_EQ(once.particles.velocity.z, often.particles.velocity.z) << name;
    EXPECT_EQ(once.particles.angular_velocity.y, often.particles.angular_velocity.y) << name;
  }
}

TEST(Engine, AdvanceByNoStepChangesNothing) {
  for (const auto& [name, bed] : agitated_beds()) {
    Engine engine = bed.engine(1, as_numbered(241));
    engine.advance(300);
    const auto before = bits(engine);
    engine.advance(0);
    EXPECT_TRUE(bits(engine) == before) << name;
  }
}

// Moved by hand before the stop: the list that is restored does not know the pair.
TEST(Engine, RestoresASphereThatWasMoved) {
  for (double x : {0.0, 1.5 * radius}) {
    const Contact contact = linear(0.9, 50);
    Engine engine = make_engine(contact, {}, {0, 0, 0}, 1);
    engine.add_particle({-20 * radius, 0, 0}, radius, density, 0);
    engine.add_particle({0, 0, 0}, radius, density, 0);
    engine.advance(10);
    engine.particles.position.x[0] = x - 1.99 * radius;
    engine.particles.position.x[1] = x;
    Engine resumed = make_engine(contact, {}, {0, 0, 0}, 1);
    resumed.restore(engine.particles, engine.memory());
    engine.advance(1);
    resumed.advance(1);
    EXPECT_EQ(engine.contacts(1), 1);
    EXPECT_EQ(resumed.contacts(1), 1);
  }
}

// A hertzian wall that does not deform is twice as stiff.
TEST(Engine, NetworkFrequencyKnowsRigidWalls) {
  double squared[2] = {};
  for (bool rigid : {false, true}) {
    Contact contact = linear(0.9, 50);
    contact.law = "hertz";
    contact.youngs_modulus = 1e8;
    contact.rigid_walls = rigid;
    Engine engine = make_engine(contact, {{Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
    engine.add_particle({0, 0, 0.999 * radius}, radius, density, 0);
    engine.advance(1);
    squared[rigid] = engine.network_frequency_squared();
  }
  EXPECT_NEAR(squared[1] / squared[0], 2.0, 0.05);
}

// --- the start -------------------------------------------------------------------------------------------------------

/// FNV-1a of numbers as 64-bit integers.
std::uint64_t hash(const std::vector<std::int64_t>& values) {
  std::uint64_t h = 14695981039346656037u;
  for (std::int64_t value : values)
    for (int byte = 0; byte < 8; ++byte) {
      h ^= (static_cast<std::uint64_t>(value) >> (8 * byte)) & 0xff;
      h *= 1099511628211u;
    }
  return h;
}

// Coordinates in nanometres and species of the first spheres: recorded once, the same on any machine.
TEST(LoosePacking, IsThatOfAnyMachine) {
  Scene scene = column(150);
  scene.species.push_back({"small", 0.004, 2500.0, 50});
  scene.seed = 42;
  std::vector<std::int64_t> numbers;
  const auto spheres = start_positions(scene);
  ASSERT_EQ(spheres.size(), 200u);
  for (std::size_t i = 0; i < 100; ++i) {
    for (double coordinate : spheres[i].centre) numbers.push_back(std::llround(coordinate * 1e9));
    numbers.push_back(spheres[i].species);
  }
  EXPECT_EQ(hash(numbers), 14005443266666889785u);
  EXPECT_EQ(numbers[0], -8269473);
}

}  // namespace
}  // namespace slfb::dem
