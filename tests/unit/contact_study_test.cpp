// What a comparison says of contact laws: two bodies that meet do what exact solutions say, and planted faults are
// found, and nothing else.

#include "experiments/compare/contact_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/peng_2014/comparison.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/dem/hertz_mindlin.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

const ComparisonBed& bed() {
  static const ComparisonBed the_bed = paper::comparison_bed();
  return the_bed;
}

Contact sound_contact() {
  Contact contact;
  contact.stiffness = 1e3;
  contact.youngs_modulus = 8e6;
  contact.restitution = 0.9;
  contact.sliding_friction = 0.3;
  contact.time_step = 1e-5;
  return contact;
}

ComparedContactLaw compared(const std::string& law, const Contact& contact = sound_contact()) {
  ComparedContactLaw compared{law, law, {}, contact, find_contact_law(law)};
  compared.contact.law = law;
  return compared;
}

Rebound resolved(const ComparedContactLaw& law, const Impact& impact) {
  return collide(law, impact, resolving_step(law, impact));
}

double mass_of_glass() { return paper::glass_density * std::numbers::pi / 6.0 * std::pow(0.005, 3); }

// A half period of the damped oscillator; the frame of the common centre keeps e² of the energy.
TEST(Collide, OfALinearSpringIsAHalfPeriod) {
  const ComparedContactLaw law = compared("linear");
  const Rebound rebound = resolved(law, bed_impact(bed(), 0.1));
  ASSERT_TRUE(rebound.parted);
  const double mass = 0.5 * mass_of_glass();
  EXPECT_NEAR(rebound.restitution, 0.9, 1e-4);
  EXPECT_NEAR(rebound.energy, 0.81, 2e-4);
  EXPECT_NEAR(rebound.duration, dem::LinearSpringDashpot::contact_time(1e3, 0.9, mass), 1e-3 * rebound.duration);
  const double zeta = -std::log(0.9) / std::hypot(std::numbers::pi, std::log(0.9));
  const double angle = std::acos(zeta);  // of the deepest overlap
  const double deepest = 0.1 * std::sqrt(mass / 1e3) * std::exp(-zeta / std::sqrt(1.0 - zeta * zeta) * angle);
  EXPECT_NEAR(rebound.overlap * 0.00125, deepest, 1e-3 * deepest);
}

// Landau & Lifshitz, Theory of Elasticity, §9: duration and, from the energy, the peak force of an elastic impact.
TEST(Collide, OfElasticSpheresIsHertzs) {
  Contact contact = sound_contact();
  contact.restitution = 1.0;
  const ComparedContactLaw law = compared("hertz", contact);
  const double mass = 0.5 * mass_of_glass(), radius = 0.00125, modulus = 8e6 / (2.0 * (1.0 - 0.0625));
  for (const double speed : {0.02, 0.5}) {
    const Rebound rebound = resolved(law, bed_impact(bed(), speed));
    const double duration = 2.8683 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2);
    EXPECT_NEAR(rebound.duration, duration, 2e-3 * duration);
    const double stiffness = 4.0 / 3.0 * modulus * std::sqrt(radius);
    const double peak = stiffness * std::pow(1.25 * mass * speed * speed / stiffness, 0.6);
    EXPECT_NEAR(rebound.peak_force, peak, 1e-3 * peak);
    EXPECT_NEAR(rebound.energy, 1.0, 1e-4);
  }
}

// A rigid sphere that slides from start to end: Δv_t = μ (1 + e) v_n, and 5/2 of it as speed of the surface.
TEST(Collide, AGrazingImpactIsThatOfARigidSphere) {
  Contact hard = sound_contact();
  hard.stiffness = 1e6;
  hard.youngs_modulus = 8e9;
  for (const char* name : {"linear", "hertz"}) {
    const ComparedContactLaw law = compared(name, hard);
    const Impact impact = oblique_impact(bed(), 80.0);
    const Rebound rebound = resolved(law, impact);
    const double lost = 0.3 * (1.0 + rebound.restitution) * impact.speed;
    EXPECT_NEAR(rebound.tangential_speed, impact.tangential_speed - lost, 0.005 * lost) << name;
    EXPECT_NEAR(0.0025 * rebound.angular_speed, 2.5 * lost, 0.01 * lost) << name;
  }
}

// Lubrication from h_0 to the roughness h_1, and as strong as there until they touch, takes 6πμR²/m ln(h_0/h_1) of the
// speed, whatever that is; there, and back. Between, a contact that is nearly rigid.
TEST(WetRestitution, IsThatOfTheWorkOfLubrication) {
  Contact contact = sound_contact();
  contact.restitution = 1.0;
  contact.stiffness = 1e6;
  const ComparedContactLaw law = compared("linear", contact);
  const auto [outer, inner] = lubrication_gaps(bed());
  const double mass = mass_of_glass(), factor = 6.0 * std::numbers::pi * paper::water().viscosity * 0.0025 * 0.0025;
  const double way = factor / mass * std::log(outer / inner);
  for (const double speed : {0.05, 0.3}) {
    const double slowed = speed - way;
    const double overlap = slowed * std::sqrt(mass / 1e6);
    // Half a period of a weakly damped oscillator loses c v² π/(2 ω) of energy, ω = v/δ.
    const double damping = factor * (1.0 / inner - 1.0 / outer);
    const double parted = slowed - damping / mass * overlap * std::numbers::pi / 2.0;
    EXPECT_NEAR(wet_restitution(law, bed(), speed), (parted - way) / speed, 0.01) << speed;
  }
  EXPECT_EQ(wet_restitution(law, bed(), 0.8 * way), 0.0);
}

TEST(ComparedContactLaws, HertzWithoutAModulusTouchesAsLongAsTheLinearLaw) {
  const RunSpec& slice = bed().one_dimensional.front();
  const auto laws = compared_contact_laws({"linear", "hertz", "hertz:youngs_modulus=1e7 Pa"}, slice, bed());
  EXPECT_EQ(laws[1].name, "hertz");
  EXPECT_EQ(laws[2].contact.youngs_modulus, 1e7);
  EXPECT_EQ(laws[2].name, "hertz:youngs_modulus=1e7 Pa");
  const double linear = resolved(laws[0], bed_impact(bed())).duration,
               hertz = resolved(laws[1], bed_impact(bed())).duration;
  EXPECT_NEAR(hertz, linear, 0.03 * linear);
}

// --- planted faults --------------------------------------------------------------------------------------------------

constexpr dem::ContactLawInfo planted_info{
    .name = "planted", .title = "", .equation = "", .source = "mine", .overlap = {0.0, 0.05}};

/// The linear law and what a fault makes of it.
template <class Fault>
struct Planted : dem::LinearSpringDashpot {
  static constexpr dem::ContactLawInfo info = planted_info;
  using LinearSpringDashpot::LinearSpringDashpot;
  dem::NormalContact operator()(double overlap, double approach, double root_mass, double radius) const {
    return Fault{}(LinearSpringDashpot::operator()(overlap, approach, root_mass, radius), overlap, approach);
  }
};

struct Nothing {
  dem::NormalContact operator()(dem::NormalContact c, double, double) const { return c; }
};
struct PushesWhileTheyPart {
  dem::NormalContact operator()(dem::NormalContact c, double overlap, double approach) const {
    if (approach < 0.0) c.force = c.load = 1.5 * 1e3 * overlap;
    return c;
  }
};
struct LessDampedThanAsked {
  dem::NormalContact operator()(dem::NormalContact c, double overlap, double) const {
    c.force = 1e3 * overlap + 0.5 * (c.force - 1e3 * overlap);
    c.load = 1e3 * overlap + 0.5 * (c.load - 1e3 * overlap);
    return c;
  }
};
struct StatesHalfItsStiffness {
  dem::NormalContact operator()(dem::NormalContact c, double, double) const {
    c.stiffness *= 0.5;
    return c;
  }
};
struct StartsWithAStep {
  dem::NormalContact operator()(dem::NormalContact c, double, double) const {
    c.force += 2e-3;
    c.load += 2e-3;
    return c;
  }
};
struct FrictionOfTwiceTheLoad {
  dem::NormalContact operator()(dem::NormalContact c, double, double) const {
    c.load *= 2.0;
    return c;
  }
};
struct Counts {
  dem::NormalContact operator()(dem::NormalContact c, double, double) const {
    static double calls = 0.0;
    c.force *= 1.0 + 1e-12 * ++calls;
    return c;
  }
};

enum Place { energy, oblique, energy_at_step, restitution, step, push, slope, friction, grazing, momentum, memory };

/// Which of the properties do not hold, by their place.
template <class Fault>
std::vector<int> failing() {
  ComparedContactLaw law{"planted", "", {}, sound_contact(), dem::contact_kernels_of<Planted<Fault>>()};
  std::vector<int> places;
  const auto checks = check_properties(law, bed());
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (!checks[i].holds) places.push_back(static_cast<int>(i));
  return places;
}

TEST(ContactProperties, ASoundLawHasAll) { EXPECT_EQ(failing<Nothing>(), (std::vector<int>{})); }

TEST(ContactProperties, PlantedFaultsAreFound) {
  // Where the load jumps up, the tangential spring sticks until it carries the new limit.
  EXPECT_EQ(failing<PushesWhileTheyPart>(), (std::vector<int>{energy, oblique, energy_at_step, restitution, grazing}));
  EXPECT_EQ(failing<LessDampedThanAsked>(), (std::vector<int>{restitution}));
  EXPECT_EQ(failing<StatesHalfItsStiffness>(), (std::vector<int>{slope}));
  EXPECT_EQ(failing<FrictionOfTwiceTheLoad>(), (std::vector<int>{friction, grazing}));
  EXPECT_EQ(failing<Counts>(), (std::vector<int>{memory}));
  const auto step_at_touch = failing<StartsWithAStep>();
  EXPECT_NE(std::ranges::find(step_at_touch, static_cast<int>(push)), step_at_touch.end());
}

TEST(ContactProperties, ACoarseStepIsFound) {
  ComparedContactLaw law = compared("linear");
  law.contact.time_step = 1e-4;
  EXPECT_TRUE(check_properties(law, bed())[step].holds);
  law.contact.time_step = 4e-4;
  EXPECT_FALSE(check_properties(law, bed())[step].holds);
}

TEST(ContactProperties, SpheresThatStickAreAnError) {
  struct Sticks {
    dem::NormalContact operator()(dem::NormalContact c, double, double approach) const {
      c.force = c.load = approach > 0.0 ? c.force : 0.0;
      return c;
    }
  };
  ComparedContactLaw law{"sticks", "", {}, sound_contact(), dem::contact_kernels_of<Planted<Sticks>>()};
  const std::string message = [&] {
    try {
      check_properties(law, bed());
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  }();
  EXPECT_NE(message.find("do not part"), std::string::npos) << message;
}

/// What characterise says of a faulty law.
template <class Fault>
std::string error_of() {
  const ComparedContactLaw law{"planted", "mine.cpp", {}, sound_contact(), dem::contact_kernels_of<Planted<Fault>>()};
  try {
    characterise(law, bed());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// Whose force is no number, or draws the spheres into each other, is named with its file before any bed is simulated.
TEST(ContactFindings, ALawThatCannotMoveTwoBodiesIsNamed) {
  struct RootOfANegativeNumber {
    dem::NormalContact operator()(dem::NormalContact c, double, double approach) const {
      c.force = std::sqrt(c.force * approach);
      return c;
    }
  };
  struct Attracts {
    dem::NormalContact operator()(dem::NormalContact c, double, double) const {
      c.force = -c.force;
      return c;
    }
  };
  const std::string no_number = error_of<RootOfANegativeNumber>();
  EXPECT_NE(no_number.find("mine.cpp"), std::string::npos) << no_number;
  EXPECT_NE(no_number.find("an approach of -0.1 m/s; needed are finite numbers"), std::string::npos) << no_number;
  EXPECT_NE(error_of<Attracts>().find("mine.cpp: two bodies that meet"), std::string::npos) << error_of<Attracts>();
}

TEST(UsesOutsideRange, AreThoseOfTheStatedOverlap) {
  EXPECT_TRUE(uses_outside_range(compared("linear"), bed(), {}).empty());
  const auto soft = uses_outside_range(
      compared("hertz"), bed(), {{measure_key("maximum_overlap_mean", "6in5W", 0.06), {0.02, 0.001, 9, "-", ""}}});
  ASSERT_EQ(soft.size(), 3u);
  EXPECT_NE(soft[2].find("0.06 m/s"), std::string::npos) << soft[2];
  Contact hard = sound_contact();
  hard.youngs_modulus = 7e10;
  EXPECT_TRUE(uses_outside_range(compared("hertz", hard), bed(), {}).empty());
}

}  // namespace
}  // namespace slfb::compare
