// Normal contacts of the particle engine: free fall and bounce, restitution, peak and duration of collisions, chains of
// contacts and walls, against closed forms and the CVODE reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <vector>

#include "correlations/materials.hpp"
#include "solver/dem/contact_reference.hpp"
#include "solver/dem/hertz_mindlin.hpp"
#include "solver/laws/make_engine.hpp"
#include "tests/verification/few_spheres.hpp"

namespace slfb::dem {
namespace {

using std::numbers::pi;

constexpr double radius = 0.0025, density = 2230.0;

Contact glass(double restitution, int steps_per_contact, double friction = 0.0) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.restitution = restitution;
  contact.sliding_friction = friction;
  const double effective_mass = 0.5 * density * Particles::volume_of(radius);
  contact.time_step =
      LinearSpringDashpot::contact_time(contact.stiffness, restitution, effective_mass) / steps_per_contact;
  return contact;
}

// --- free fall and bounce --------------------------------------------------------------------------------------------

constexpr double drop_radius = 0.1, drop_density = 2600.0, drop_height = 0.5;

Engine dropped_sphere(Integrator integrator, double stiffness, double time_step) {
  Contact contact;
  contact.stiffness = stiffness;
  contact.restitution = 0.9;
  contact.integrator = integrator;
  contact.time_step = time_step;
  Engine engine = engine_with(contact, {floor_at_zero}, {{{0, 0, drop_height}, {}, {}, drop_radius, drop_density}});
  engine.external_force.z[0] = -engine.particles.mass[0] * gravitational_acceleration;
  return engine;
}

// DEM01 of MFIX (Garg et al. 2012, Powder Technol. 220:122): from 0.5 m onto a plane the contact starts at
// √(2 (h_0 − r)/g) = 0.285569 s with 2.80143 m/s; the damped oscillator about r − m g/k ends it.
TEST(Bounce, FallsTouchesAndLeavesOnTime) {
  struct Case {
    double stiffness, end, rebound;
  };
  for (const Integrator integrator : all_integrators)
    for (const Case& exact : {Case{1e4, 0.397388, 2.47586}, Case{5e4, 0.333575, 2.50203}}) {
      const double time_step = 1e-5;
      Engine engine = dropped_sphere(integrator, exact.stiffness, time_step);
      const auto& z = engine.particles.position.z[0];
      const auto& v = engine.particles.velocity.z[0];
      // Crossings of z = r, in proportion within their steps.
      double crossing[2], speed[2];
      int crossings = 0;
      for (int k = 0; crossings < 2 && k < 50000; ++k) {
        const double z_before = z, v_before = v;
        engine.step();
        if ((z_before < drop_radius) == (z < drop_radius)) continue;
        const double share = (drop_radius - z_before) / (z - z_before);
        crossing[crossings] = (k + share) * time_step;
        speed[crossings++] = v_before + share * (v - v_before);
      }
      ASSERT_EQ(crossings, 2);
      EXPECT_NEAR(crossing[0], 0.285569, 6e-6) << name_of(integrator);
      EXPECT_NEAR(-speed[0], 2.80143, 6e-5) << name_of(integrator);
      EXPECT_NEAR(crossing[1], exact.end, 1e-5) << name_of(integrator);
      EXPECT_NEAR(speed[1], exact.rebound, 1.5e-4) << name_of(integrator);
    }
}

std::vector<double> heights_of_bounces(Integrator integrator, double stiffness, double time_step, std::size_t bounces) {
  Engine engine = dropped_sphere(integrator, stiffness, time_step);
  const auto& z = engine.particles.position.z[0];
  std::vector<double> heights;
  double highest = 0.0;
  while (heights.size() < bounces) {
    engine.step();
    if (z >= drop_radius) {
      highest = std::max(highest, z);
    } else if (highest > 0.0) {
      heights.push_back(highest);
      highest = 0.0;
    }
  }
  return heights;
}

// DEM02 of MFIX: h_k = r + (h_0 − r) e^{2k} for a contact so short that gravity does next to nothing in it: 0.8 % less
// by the tenth.
TEST(Bounce, TenHeightsOfAHardSphere) {
  const auto heights = heights_of_bounces(Integrator::velocity_verlet, 5e7, 1.5e-5, 11);
  for (std::size_t k = 1; k < heights.size(); ++k)
    EXPECT_NEAR(heights[k], drop_radius + (drop_height - drop_radius) * std::pow(0.9, 2.0 * static_cast<double>(k)),
                1e-2 * (heights[k] - drop_radius))
        << k;
}

// The same at the k = 5e4 N/m of MFIX, where gravity matters in the contact: rebounds are those of the exact motion.
TEST(Bounce, TenHeightsOfASoftSphere) {
  ReferenceLaw law;
  law.stiffness = 5e4;
  law.restitution = 0.9;
  const auto run = reference_bounce(law, drop_radius, drop_density * Particles::volume_of(drop_radius),
                                    gravitational_acceleration, drop_height, {4.5});
  std::vector<double> exact{drop_height};
  for (const auto& event : run.events)
    if (event.kind == ReferenceEventKind::contact_end)
      exact.push_back(drop_radius +
                      event.state.velocity[0] * event.state.velocity[0] / (2.0 * gravitational_acceleration));
  ASSERT_GE(exact.size(), 11U);
  for (const Integrator integrator : all_integrators) {
    const auto heights = heights_of_bounces(integrator, 5e4, 5e-5, 11);
    for (std::size_t k = 1; k < heights.size(); ++k)
      EXPECT_NEAR(heights[k], exact[k], 1e-3 * (exact[k] - drop_radius)) << name_of(integrator) << " " << k;
  }
}

// --- restitution -----------------------------------------------------------------------------------------------------

enum class Bodies { equal, unequal, wall };

struct Collider {
  std::string law = "linear";
  Integrator integrator = Integrator::velocity_verlet;
  Bodies bodies = Bodies::equal;
  double restitution = 0.9;
  bool cut_tension = false;
  Vec3 direction{1, 0, 0};

  /// Outgoing over incoming speed. `steps` per contact, for Hertz per elastic one; `phase`: where in a step the spheres
  /// meet, 0 < phase < 1.
  [[nodiscard]] double rebound(double steps, double phase) const {
    const double speed = 0.1;
    const double r1 = bodies == Bodies::equal ? radius : 0.004, density1 = bodies == Bodies::equal ? density : 7000.0;
    const double m0 = density * Particles::volume_of(radius), m1 = density1 * Particles::volume_of(r1);
    const bool wall = bodies == Bodies::wall;
    const double share = wall ? 1.0 : m1 / (m0 + m1);  // of the speed that the first sphere has
    Contact contact;
    contact.law = law;
    contact.integrator = integrator;
    contact.restitution = restitution;
    contact.cut_tension = cut_tension;
    contact.stiffness = 1e4;
    contact.youngs_modulus = 1e8;
    contact.poisson_ratio = 0.25;
    const double modulus = contact.youngs_modulus / (2.0 * (1.0 - 0.25 * 0.25));
    const double duration =
        law == "linear"
            ? LinearSpringDashpot::contact_time(contact.stiffness, restitution, share * m0)
            : HertzMindlin::contact_time(modulus, wall ? radius : radius * r1 / (radius + r1), share * m0, speed);
    contact.time_step = duration / steps;
    const double gap = (3.0 - phase) * contact.time_step * speed;
    std::vector<Wall> walls;
    if (wall) walls.push_back({Wall::Kind::plane, 0, -1.0, 0.0});
    Engine engine =
        engine_with(contact, walls, {{(-radius - gap) * direction, (share * speed) * direction, {}, radius, density}});
    if (!wall) {
      engine.add_particle({r1 * direction.x, r1 * direction.y, r1 * direction.z}, r1, density1, 0);
      engine.particles.velocity.x[1] = -(1.0 - share) * speed * direction.x;
      engine.particles.velocity.y[1] = -(1.0 - share) * speed * direction.y;
      engine.particles.velocity.z[1] = -(1.0 - share) * speed * direction.z;
    }
    engine.advance(static_cast<std::int64_t>(2.5 * steps) + 10);
    EXPECT_EQ(engine.touching_pairs().size(), 0U);
    Vec3 relative = at(engine.particles.velocity, 0);
    if (!wall) relative = relative - at(engine.particles.velocity, 1);
    return -dot(relative, direction) / speed;
  }

  struct Errors {
    double mean = 0.0, largest = 0.0;
  };
  /// Of the restitution over `phases` phases. That they hit no special one, steps are not a whole number per contact.
  [[nodiscard]] Errors errors(int steps, int phases, double expected) const {
    Errors errors;
    for (int k = 0; k < phases; ++k) {
      const double error = rebound(steps + 0.37, (k + 0.41) / phases) - expected;
      errors.mean += error / phases;
      errors.largest = std::max(errors.largest, std::abs(error));
    }
    return errors;
  }
};

std::ostream& operator<<(std::ostream& out, const Collider& c) {
  return out << c.law << ", " << name_of(c.integrator) << ", bodies " << static_cast<int>(c.bodies)
             << ", e = " << c.restitution;
}

const std::array<std::string, 2> all_laws{"linear", "hertz"};
constexpr std::array all_bodies{Bodies::equal, Bodies::unequal, Bodies::wall};

template <class Check>
void for_all_colliders(Check check) {
  for (const std::string& law : all_laws)
    for (const Integrator integrator : all_integrators)
      for (const Bodies bodies : all_bodies)
        for (const double e : {0.3, 0.5, 0.7, 0.9, 1.0}) check(Collider{law, integrator, bodies, e, false, {1, 0, 0}});
}

// Out as in, within 1e-3 at 100 steps per contact, wherever in a step the spheres meet.
TEST(Restitution, IsThatOfTheLaw) {
  for_all_colliders([](const Collider& collider) {
    EXPECT_LT(collider.errors(100, 16, collider.restitution).largest, 1e-3) << collider;
  });
}

// Of second order but for the Hertzian dashpot, which begins as δ^{1/4}: of order 5/4.
TEST(Restitution, ConvergesWithTheStep) {
  for (const std::string& law : all_laws)
    for (const Integrator integrator : all_integrators)
      for (const double e : {0.3, 0.5, 0.7, 0.9, 1.0}) {
        const Collider collider{law, integrator, Bodies::wall, e, false, {1, 0, 0}};
        std::vector<double> largest;
        for (const int steps : {50, 100, 200, 400, 800}) largest.push_back(collider.errors(steps, 8, e).largest);
        EXPECT_GT(order_of(largest), law == "linear" || e == 1.0 ? 1.75 : 0.8) << collider;
      }
}

// The law knows no direction.
TEST(Restitution, IsTheSameInAllDirections) {
  for (const std::string& law : all_laws)
    for (const Integrator integrator : all_integrators)
      for (const Bodies bodies : {Bodies::equal, Bodies::unequal}) {
        Collider collider{law, integrator, bodies, 0.7, false, {1, 0, 0}};
        const double along_x = collider.rebound(100, 0.37);
        for (const Vec3 direction : {Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0.6, 0.0, 0.8},
                                     Vec3{2.0 / 3, -1.0 / 3, 2.0 / 3}, Vec3{0.48, 0.6, -0.64}}) {
          collider.direction = direction;
          EXPECT_NEAR(collider.rebound(100, 0.37), along_x, 1e-9) << collider;
        }
      }
}

// Schwager & Pöschel (2007), Granular Matter 9:465, Eq. 21: what is left of e when the spheres part where the force
// vanishes. Of a Hertzian contact by the reference.
TEST(Restitution, IsHigherWithoutTension) {
  for (const std::string& law : all_laws)
    for (const Integrator integrator : all_integrators)
      for (const Bodies bodies : all_bodies)
        for (const double e : {0.3, 0.5, 0.7, 0.9}) {
          const Collider collider{law, integrator, bodies, e, true, {1, 0, 0}};
          double expected = LinearSpringDashpot::restitution_without_tension(e);
          if (law == "hertz") {
            ReferenceLine line;
            line.law.kind = ReferenceLaw::Kind::hertz_mindlin;
            line.law.modulus = 1e8;
            line.law.restitution = e;
            line.law.cut_tension = true;
            line.spheres = {{radius, 1e-4, radius, -0.1}};
            line.lower_wall = 0.0;
            expected = reference_line(line, {0.1}).samples.back().velocity[0] / 0.1;
          }
          const auto errors = collider.errors(400, 8, expected);
          EXPECT_LT(errors.largest, 1e-4) << collider;
        }
}

// A damped oscillator touches for π/(ω_0 √(1 − ζ²)); the overlap peaks at v/ω_0 for e = 1.
TEST(LinearContact, LastsHalfAPeriodAndPenetratesAsAnOscillator) {
  for (const double e : {1.0, 0.5}) {
    const Contact contact = glass(e, 500);
    Engine engine = engine_with(contact, {},
                                {{{-1.0001 * radius, 0, 0}, {0.05, 0, 0}, {}, radius, density},
                                 {{1.0001 * radius, 0, 0}, {-0.05, 0, 0}, {}, radius, density}});
    int touching = 0;
    double deepest = 0.0;
    for (int k = 0; k < 1500; ++k) {
      engine.step();
      if (engine.contacts(0) == 0) continue;
      ++touching;
      deepest = std::max(deepest, engine.maximum_overlap() * radius);
    }
    const double effective_mass = 0.5 * density * Particles::volume_of(radius), zeta = damping_ratio(e);
    // The peak of a damped oscillator, where tan ω t = √(1 − ζ²)/ζ.
    const double root = std::sqrt(1.0 - zeta * zeta);
    const double peak = 0.1 * std::sqrt(effective_mass / contact.stiffness) * std::exp(-zeta / root * std::acos(zeta));
    EXPECT_NEAR(touching, 500, 3);
    EXPECT_NEAR(deepest, peak, 5e-3 * peak);
  }
}

// Peng (2014), Table 1: 2.69e-4 s for 5 mm glass pairs at 1e4 N/m, 1.25e-4 s for 3 mm, so 5.4 and 2.5 steps of 5e-5 s.
TEST(LinearContact, PaperHasFiveStepsPerContact) {
  const auto contact_time = [](double diameter) {
    return LinearSpringDashpot::contact_time(1e4, 0.9, 0.5 * density * Particles::volume_of(0.5 * diameter));
  };
  EXPECT_NEAR(contact_time(0.005), 2.69e-4, 0.005e-4);
  EXPECT_NEAR(contact_time(0.003), 1.25e-4, 0.005e-4);
}

// Chung & Ooi (2011), Granular Matter 13:643, tests 1 to 3: peak overlap and force and the duration of elastic Hertzian
// impacts, δ = (15 m_eff v²/(16 E* √R*))^{2/5}, F = 4/3 E* √R* δ^{3/2}, 2.943 δ/v.
TEST(HertzContact, ImpactsOfChungAndOoi) {
  struct Case {
    const char* name;
    bool wall;
    double youngs_modulus, poisson_ratio, density, radius, speed, overlap, force, duration;
  };
  for (const Case& c : {Case{"1, glass", false, 48e9, 0.20, 2800, 0.01, 10.0, 274.11e-6, 10697, 40.34e-6},
                        Case{"1, limestone", false, 20e9, 0.25, 2500, 0.01, 10.0, 368.30e-6, 7108, 54.20e-6},
                        Case{"2, aluminium", true, 70e9, 0.30, 2699, 0.1, 0.2, 49.72e-6, 11370, 731.7e-6},
                        Case{"2, magnesium", true, 40e9, 0.35, 1800, 0.1, 0.2, 52.12e-6, 7233, 767.1e-6},
                        Case{"3, aluminium oxide", true, 380e9, 0.23, 4000, 0.0025, 3.9, 8.089e-6, 615.4, 6.105e-6},
                        Case{"3, cast iron", true, 100e9, 0.25, 7000, 0.0025, 3.9, 17.19e-6, 506.8, 12.97e-6}}) {
    Contact contact;
    contact.law = "hertz";
    contact.integrator = Integrator::velocity_verlet;
    contact.youngs_modulus = c.youngs_modulus;
    contact.poisson_ratio = c.poisson_ratio;
    contact.rigid_walls = true;
    contact.restitution = 1.0;
    contact.sliding_friction = 0.0;
    contact.time_step = c.duration / 2000.0;
    const double gap = 2.5 * contact.time_step * c.speed;
    std::vector<Sphere> spheres{{{0, 0, c.radius + gap}, {0, 0, -c.speed}, {}, c.radius, c.density}};
    if (!c.wall) spheres.push_back({{0, 0, -c.radius - gap}, {0, 0, c.speed}, {}, c.radius, c.density});
    const std::vector<Wall> walls(c.wall ? 1 : 0, floor_at_zero);
    Engine engine = engine_with(contact, walls, spheres);
    double overlap = 0.0, force = 0.0, duration = 0.0;
    for (int k = 0; k < 2100; ++k) {
      engine.step();
      overlap = std::max(overlap, engine.maximum_overlap() * c.radius);
      force = std::max(force, engine.contact_force(0)[2] + engine.wall_force(0)[2]);
      duration += engine.touching_pairs().empty() ? 0.0 : contact.time_step;
    }
    // To the digits given.
    EXPECT_NEAR(overlap, c.overlap, 2e-4 * c.overlap) << c.name;
    EXPECT_NEAR(force, c.force, 3e-4 * c.force) << c.name;
    EXPECT_NEAR(duration, c.duration, 1e-3 * c.duration) << c.name;
    EXPECT_NEAR(engine.particles.velocity.z[0], c.speed, 1e-6 * c.speed) << c.name;
  }
}

// --- several contacts at once ----------------------------------------------------------------------------------------

// DEM03 of MFIX: two unequal spheres squeezed between two planes, against the reference.
TEST(Stack, SqueezedSpheresMoveAsTheReference) {
  const double r = 0.0005, end = 5e-3;
  for (const double e : {1.0, 0.8})
    for (const std::string& law : all_laws) {
      ReferenceLine line;
      line.law.kind = law == "linear" ? ReferenceLaw::Kind::linear : ReferenceLaw::Kind::hertz_mindlin;
      line.law.stiffness = 1e3;
      line.law.modulus = 1e7 / (2.0 * (1.0 - 0.25 * 0.25));
      line.law.restitution = e;
      line.spheres = {{r, 2e4 * Particles::volume_of(r), 0.45e-3, 0.0}, {r, 1e4 * Particles::volume_of(r), 1.35e-3, 0}};
      line.gravity = gravitational_acceleration;
      line.lower_wall = 0.0;
      line.upper_wall = 1.8e-3;
      const auto exact = reference_line(line, {end}).samples.back();
      for (const Integrator integrator : all_integrators) {
        // Started in contact, at accelerations that an integrator does not know yet: a first order error.
        double error[2];
        for (const int level : {0, 1}) {
          Contact contact;
          contact.law = law;
          contact.integrator = integrator;
          contact.stiffness = line.law.stiffness;
          contact.youngs_modulus = 1e7;
          contact.poisson_ratio = 0.25;
          contact.restitution = e;
          contact.time_step = level == 0 ? 2e-6 : 1e-6;
          Engine engine = engine_with(contact, {floor_at_zero, {Wall::Kind::plane, 2, -1.0, 1.8e-3}},
                                      {{{0, 0, 0.45e-3}, {}, {}, r, 2e4}, {{0, 0, 1.35e-3}, {}, {}, r, 1e4}});
          for (std::size_t i : {0U, 1U})
            engine.external_force.z[i] = -engine.particles.mass[i] * gravitational_acceleration;
          engine.advance(std::llround(end / contact.time_step));
          error[level] = 0.0;
          for (std::size_t i : {0U, 1U})
            error[level] = std::max(error[level], std::abs(engine.particles.position.z[i] - exact.position[i]));
        }
        EXPECT_LT(error[0], integrator == Integrator::symplectic_euler ? 3e-7 : 2e-7)
            << law << ", " << name_of(integrator) << ", e = " << e;
        EXPECT_LT(error[1], 0.7 * error[0]) << law << ", " << name_of(integrator) << ", e = " << e;
      }
    }
}

// Three unequal spheres in a row, the first two touching when the third strikes: contacts that overlap in time.
TEST(Stack, CradleMovesAsTheReference) {
  const double e = 0.9, end = 2e-3;
  for (const std::string& law : all_laws) {
    ReferenceLine line;
    line.law.kind = law == "linear" ? ReferenceLaw::Kind::linear : ReferenceLaw::Kind::hertz_mindlin;
    line.law.stiffness = 1e4;
    line.law.modulus = 1e8 / (2.0 * (1.0 - 0.25 * 0.25));
    line.law.restitution = e;
    const double mass = density * Particles::volume_of(radius);
    line.spheres = {{radius, 2.0 * mass, 0.0, 0.0},
                    {radius, mass, 2.0001 * radius, 0.0},
                    {radius, 0.7 * mass, 4.01 * radius, -0.3}};
    const auto exact = reference_line(line, {end}).samples.back();
    for (const Integrator integrator : all_integrators) {
      Contact contact;
      contact.law = law;
      contact.integrator = integrator;
      contact.stiffness = line.law.stiffness;
      contact.youngs_modulus = 1e8;
      contact.poisson_ratio = 0.25;
      contact.restitution = e;
      contact.time_step = 2.5e-7;
      Engine engine = engine_with(contact, {},
                                  {{{0, 0, 0}, {}, {}, radius, 2.0 * density},
                                   {{0, 0, 2.0001 * radius}, {}, {}, radius, density},
                                   {{0, 0, 4.01 * radius}, {0, 0, -0.3}, {}, radius, 0.7 * density}});
      engine.advance(std::llround(end / contact.time_step));
      for (std::size_t i : {0U, 1U, 2U})
        EXPECT_NEAR(engine.particles.velocity.z[i], exact.velocity[i], 3e-4 * 0.3)
            << law << ", " << name_of(integrator) << ", sphere " << i;
    }
  }
}

// --- walls -----------------------------------------------------------------------------------------------------------

// Inside a cylinder of radius R the outcome is that at a plane but for the turn of the normal along the contact, r/R.
TEST(CylinderWall, IsAPlaneInTheLimitOfAWideOne) {
  const Contact contact = glass(1.0, 200, 0.2);
  const auto outcome = [&](const Wall& wall) {
    const double gap = 0.25 * 0.1 * contact.time_step;
    Engine engine = engine_with(
        contact, {wall}, {{{wall.position - radius - gap, 0, 0}, {0.1, 0.08, 0.05}, {10, 0, 20}, radius, density}});
    engine.advance(400);
    EXPECT_TRUE(engine.touching_pairs().empty());
    return std::pair{at(engine.particles.velocity, 0), at(engine.particles.angular_velocity, 0)};
  };
  std::vector<double> errors;
  for (const double wide : {0.05, 0.1, 0.2, 0.4, 50.0}) {
    const auto [v, w] = outcome({Wall::Kind::cylinder, 0, 1.0, wide});
    const auto [plane_v, plane_w] = outcome({Wall::Kind::plane, 0, -1.0, wide});
    errors.push_back(norm(v - plane_v) + radius * norm(w - plane_w));
  }
  EXPECT_LT(errors[4], 1e-6);
  errors.pop_back();
  EXPECT_NEAR(order_of(errors), 1.0, 0.1);
}

// Wherever on the wall of the cylinder the impact is, it is the same turned about the axis.
TEST(CylinderWall, IsTheSameAllAround) {
  const Contact contact = glass(0.8, 100, 0.2);
  const auto outcome = [&](double angle) {
    const auto turned = [&angle](Vec3 a) {
      return Vec3{std::cos(angle) * a.x - std::sin(angle) * a.y, std::sin(angle) * a.x + std::cos(angle) * a.y, a.z};
    };
    Engine engine = engine_with(contact, {{Wall::Kind::cylinder, 0, 1.0, 4.0 * radius}},
                                {{turned({2.999 * radius, 0, 0}), turned({0.1, 0.08, 0.05}), {}, radius, density}});
    engine.advance(400);
    EXPECT_TRUE(engine.touching_pairs().empty());
    angle = -angle;
    return std::pair{turned(at(engine.particles.velocity, 0)), turned(at(engine.particles.angular_velocity, 0))};
  };
  const auto [v, w] = outcome(0.0);
  EXPECT_LT(v.x, -0.05);
  for (const double angle : {0.7, 2.0, 3.5, 5.5}) {
    const auto [turned_v, turned_w] = outcome(angle);
    EXPECT_LT(norm(turned_v - v) + radius * norm(turned_w - w), 1e-9) << angle;
  }
}

TEST(Engine, StopsWhenASphereLeavesThroughAWall) {
  Engine engine =
      engine_with(glass(0.9, 20), {floor_at_zero}, {{{0, 0, 1.01 * radius}, {0, 0, -500.0}, {}, radius, density}});
  EXPECT_THROW(engine.advance(100), EngineError);
  EXPECT_LE(engine.particles.position.z[0], 0.0) << "the state is that of the failure, for whoever saves it";
}

TEST(Engine, StopsAtANumberThatIsNotFinite) {
  Engine engine = engine_with(glass(0.9, 20), {}, {{{0, 0, 0}, {}, {}, radius, density}});
  engine.external_force.x[0] = std::nan("");
  EXPECT_THROW(engine.step(), EngineError);
}

// A periodic box sees a collision through its faces as it sees one in its middle.
TEST(Engine, CollidesAcrossPeriodicFaces) {
  const Contact contact = glass(0.9, 100);
  Engine inside = make_engine(contact, {}, {0.05, 0.05, 0.05}, 1),
         across = make_engine(contact, {}, {0.05, 0.05, 0.05}, 1);
  for (auto [engine, shift] : {std::pair{&inside, 0.0}, std::pair{&across, 0.025}}) {
    for (double side : {-1.0, 1.0}) {
      double x = side * 1.001 * radius + shift;
      if (x > 0.025) x -= 0.05;
      const std::size_t i = engine->add_particle({x, 0, 0}, radius, density, 0);
      engine->particles.velocity.x[i] = -side * 0.05;
    }
    for (int k = 0; k < 1000; ++k) engine->step();
  }
  EXPECT_NEAR(across.particles.velocity.x[0], inside.particles.velocity.x[0], 1e-9);
  EXPECT_EQ(across.contact_events(0), 1);
}

}  // namespace
}  // namespace slfb::dem
