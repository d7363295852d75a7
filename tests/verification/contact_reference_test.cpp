// The reference trajectories of few bodies in contact against closed forms, and against small steps of the stated law.
#include "solver/dem/contact_reference.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace slfb::dem {
namespace {

using std::numbers::pi;
using Kind = ReferenceEventKind;

constexpr double radius = 0.0025, mass = 1.5e-4;

ReferenceLaw linear(double restitution, double stiffness = 1e4) {
  ReferenceLaw law;
  law.stiffness = stiffness;
  law.restitution = restitution;
  return law;
}

// Aluminium oxide against a rigid plane of Chung & Ooi (2011), test 4.
ReferenceLaw hertz(double restitution) {
  ReferenceLaw law;
  law.kind = ReferenceLaw::Kind::hertz_mindlin;
  law.modulus = 380e9 / (1.0 - 0.23 * 0.23);
  law.shear_modulus = 380e9 / (2.0 * (1.0 + 0.23) * (2.0 - 0.23));
  law.restitution = restitution;
  return law;
}

double damping_ratio(double e) { return -std::log(e) / std::hypot(pi, std::log(e)); }

template <class State>
std::vector<State> states_at(const ReferenceTrajectory<State>& trajectory, Kind kind) {
  std::vector<State> states;
  for (const auto& event : trajectory.events)
    if (event.kind == kind) states.push_back(event.state);
  return states;
}

// DEM01 of MFIX: free fall, then a damped oscillator about r − m g/k. The numbers are those of the first δ = 0 after
// the impact, tensile part included.
TEST(ReferenceBounce, FollowsTheDampedOscillator) {
  const double r = 0.1, m = 2600.0 * 4.0 / 3.0 * pi * r * r * r, g = 9.81, height = 0.5, e = 0.9;
  const double start = std::sqrt(2.0 * (height - r) / g), speed = g * start;
  for (const auto& [stiffness, end, rebound] : {std::array{1e4, 0.397388, 2.47586}, {5e4, 0.333575, 2.50203}}) {
    std::vector<double> times;
    for (int k = 1; k <= 200; ++k) times.push_back(0.002 * k);
    const auto run = reference_bounce(linear(e, stiffness), r, m, g, height, times);
    const auto starts = states_at(run, Kind::contact_start), ends = states_at(run, Kind::contact_end);
    ASSERT_EQ(starts.size(), 1U);
    ASSERT_EQ(ends.size(), 1U);
    EXPECT_NEAR(starts[0].time, start, 1e-13);
    EXPECT_NEAR(starts[0].time, 0.285569, 5e-7);
    EXPECT_NEAR(-starts[0].velocity[0], 2.80143, 5e-6);
    EXPECT_NEAR(ends[0].time, end, 6e-7);
    EXPECT_NEAR(ends[0].velocity[0], rebound, 6e-6);
    const double omega = std::sqrt(stiffness / m), zeta = damping_ratio(e), c0 = omega * std::sqrt(1.0 - zeta * zeta);
    const double c1 = g / (omega * omega), c2 = (zeta * omega * c1 - speed) / c0;
    const auto exact = [&](double t) {
      const double decay = std::exp(-zeta * omega * t), c = std::cos(c0 * t), s = std::sin(c0 * t);
      return std::array{(c1 * c + c2 * s) * decay - c1,
                        decay * (c0 * (c2 * c - c1 * s) - zeta * omega * (c1 * c + c2 * s))};
    };
    for (const auto& state : run.samples)
      if (state.time > start && state.time < ends[0].time) {
        EXPECT_NEAR(state.gap[0], exact(state.time - start)[0], 1e-11);
        EXPECT_NEAR(state.velocity[0], exact(state.time - start)[1], 1e-10);
      } else if (state.time < start) {
        EXPECT_NEAR(state.gap[0], height - r - 0.5 * g * state.time * state.time, 1e-14);
      }
    EXPECT_NEAR(exact(ends[0].time - start)[0], 0.0, 1e-11);
    EXPECT_NEAR(ends[0].velocity[0], exact(ends[0].time - start)[1], 1e-10);
  }
}

TEST(ReferenceBounce, BouncesManyTimes) {
  const double g = 9.81;
  for (const ReferenceLaw& law : {linear(0.8), hertz(0.8), hertz(1.0)}) {
    const auto run = reference_bounce(law, radius, mass, g, 0.1, {1.4});
    const auto starts = states_at(run, Kind::contact_start), ends = states_at(run, Kind::contact_end);
    ASSERT_GE(ends.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
      // m g is small beside the contact force, so that e is all but exact.
      EXPECT_NEAR(-ends[k].velocity[0] / starts[k].velocity[0], law.restitution, law.restitution < 1.0 ? 1e-3 : 1e-10);
      if (k + 1 < starts.size()) {
        EXPECT_NEAR(starts[k + 1].time - ends[k].time, 2.0 * ends[k].velocity[0] / g, 1e-12);
      }
    }
  }
}

// Two unequal spheres: e and momentum, whatever the speed.
TEST(ReferenceLine, ReturnsItsRestitution) {
  for (const bool is_hertz : {false, true})
    for (double e : {0.1, 0.3, 0.6, 0.9, 1.0})
      for (double speed : {1e-3, 1.0}) {
        ReferenceLine line;
        line.law = is_hertz ? hertz(e) : linear(e);
        line.spheres = {{0.003, 3e-4, 0.0, 0.7 * speed}, {0.002, 1e-4, 0.00501, -0.3 * speed}};
        const auto last = reference_line(line, {1e-3 / speed}).samples.back();
        EXPECT_GT(last.gap[1], 0.0);
        EXPECT_NEAR((last.velocity[1] - last.velocity[0]) / speed, e, 1e-9) << is_hertz << " " << speed;
        EXPECT_NEAR((3e-4 * last.velocity[0] + 1e-4 * last.velocity[1]) / (1.8e-4 * speed), 1.0, 1e-12);
      }
}

// Schwager & Pöschel (2007): without tension the force ends at (π − atan 2 β ω/(ω² − β²))/ω and e = exp(−β t).
TEST(ReferenceLine, CutsTension) {
  for (double e : {0.05, 0.3, 0.9}) {
    ReferenceLine line;
    line.law = linear(e);
    line.law.cut_tension = true;
    line.spheres = {{radius, mass, 1.01 * radius, -0.2}};
    line.lower_wall = 0.0;
    const auto run = reference_line(line, {0.1});
    const double omega_0 = std::sqrt(1e4 / mass), beta = damping_ratio(e) * omega_0;
    const double omega = std::sqrt(omega_0 * omega_0 - beta * beta);
    const double duration = (pi - std::atan2(2.0 * beta * omega, omega * omega - beta * beta)) / omega;
    ASSERT_EQ(run.events.size(), 3U);
    EXPECT_EQ(run.events[1].kind, Kind::tension_start);
    EXPECT_EQ(run.events[2].kind, Kind::contact_end);
    EXPECT_NEAR((run.events[1].state.time - run.events[0].state.time) / duration, 1.0, 1e-9);
    EXPECT_NEAR(run.samples.back().velocity[0] / 0.2, std::exp(-beta * duration), 1e-9);
  }
}

// Hertz (1882): δ_max = (5 m v²/(4 k))^{2/5}, duration 2 δ_max/v ∫ dx/√(1 − x^{5/2}) = 2.943 δ_max/v. The numbers are
// those of Chung & Ooi (2011), test 1, for two glass spheres.
TEST(ReferenceLine, ImpactsAsHertz) {
  const double r = 0.01, m = 2800.0 * 4.0 / 3.0 * pi * r * r * r, v = 10.0;
  ReferenceLine line;
  line.law = hertz(1.0);
  line.law.modulus = 48e9 / (2.0 * (1.0 - 0.2 * 0.2));
  line.spheres = {{r, m, 0.0, v}, {r, m, 2.0 * r, -v}};
  const double stiffness = 4.0 / 3.0 * line.law.modulus * std::sqrt(0.5 * r);
  const double deepest = std::pow(1.25 * 0.5 * m * 4.0 * v * v / stiffness, 0.4);
  const double duration = 0.8 * std::tgamma(0.4) * std::sqrt(pi) / std::tgamma(0.9) * deepest / (2.0 * v);
  const auto run = reference_line(line, {0.5 * duration, 1e-4});
  ASSERT_EQ(run.events.size(), 1U);
  EXPECT_NEAR(run.events[0].state.time / duration, 1.0, 1e-9);
  EXPECT_NEAR(-run.samples[0].gap[1] / deepest, 1.0, 1e-9);
  EXPECT_NEAR(run.samples[0].velocity[0] / v, 0.0, 1e-9);
  EXPECT_NEAR(deepest, 274.11e-6, 0.005e-6);
  EXPECT_NEAR(duration, 40.34e-6, 0.005e-6);
}

TEST(ReferenceLine, CradlePassesTheVelocityOn) {
  for (const ReferenceLaw& law : {linear(1.0), hertz(1.0)}) {
    ReferenceLine line;
    line.law = law;
    line.spheres = {{radius, mass, 0.0, 0.5}, {radius, mass, 0.0055, 0.0}, {radius, mass, 0.0115, 0.0}};
    const auto run = reference_line(line, {0.01});
    EXPECT_EQ(run.events.size(), 4U);
    EXPECT_NEAR(run.samples[0].velocity[0], 0.0, 1e-10);
    EXPECT_NEAR(run.samples[0].velocity[1], 0.0, 1e-10);
    EXPECT_NEAR(run.samples[0].velocity[2], 0.5, 1e-10);
  }
}

// Contacts that overlap in time: spheres 1 and 2 touch at the start.
TEST(ReferenceLine, ConservesMomentumAndEnergy) {
  for (const ReferenceLaw& law : {linear(1.0), hertz(1.0), linear(0.7), hertz(0.7)}) {
    ReferenceLine line;
    line.law = law;
    line.spheres = {
        {radius, 3.0 * mass, 0.0, 0.5}, {radius, mass, 2.1 * radius, 0.0}, {radius, 2.0 * mass, 4.1 * radius, 0.0}};
    const auto last = reference_line(line, {0.01}).samples.back();
    const auto& v = last.velocity;
    EXPECT_GT(std::min(last.gap[1], last.gap[2]), 0.0);
    EXPECT_NEAR(3.0 * v[0] + v[1] + 2.0 * v[2], 1.5, 1e-12);
    const double energy = 3.0 * v[0] * v[0] + v[1] * v[1] + 2.0 * v[2] * v[2];
    if (law.restitution == 1.0)
      EXPECT_NEAR(energy, 0.75, 1e-10);
    else
      EXPECT_LT(energy, 0.7);
  }
}

// A third sphere strikes while the first two, their tension cut, still overlap; small steps come to the reference.
TEST(ReferenceLine, PushesAgainAfterTension) {
  ReferenceLine line;
  line.law = linear(0.1);
  line.law.cut_tension = true;
  line.spheres = {{radius, mass, 0.0, 0.5}, {radius, mass, 2.01 * radius, 0.0}, {radius, mass, 4.094 * radius, -0.5}};
  const auto run = reference_line(line, {2e-3});
  const auto cut = states_at(run, Kind::tension_start), again = states_at(run, Kind::tension_end);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_LT(cut[0].time, again[0].time);
  EXPECT_LT(again[0].gap[1], 0.0);
  const double time_step = 1e-9, damping = 2.0 * damping_ratio(0.1) * std::sqrt(line.law.stiffness * 0.5 * mass);
  std::array<double, 3> x, v;
  for (std::size_t i = 0; i < 3; ++i) x[i] = line.spheres[i].position, v[i] = line.spheres[i].velocity;
  for (int n = 0; n < 2000000; ++n) {
    std::array<double, 2> force{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double overlap = 2.0 * radius - (x[k + 1] - x[k]);
      if (overlap > 0.0) force[k] = std::max(line.law.stiffness * overlap + damping * (v[k] - v[k + 1]), 0.0);
    }
    v[0] -= time_step * force[0] / mass;
    v[1] += time_step * (force[0] - force[1]) / mass;
    v[2] += time_step * force[1] / mass;
    for (std::size_t i = 0; i < 3; ++i) x[i] += time_step * v[i];
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(run.samples[0].velocity[i], v[i], 1e-5);
}

// DEM03 of MFIX: two spheres squeezed between walls. As long as no contact opens the system is linear.
TEST(ReferenceLine, SqueezedStackIsALinearSystem) {
  const double r = 0.0005, g = 9.81, k = 1e3, e = 0.8, volume = 4.0 / 3.0 * pi * r * r * r;
  const double m0 = 2e4 * volume, m1 = 1e4 * volume;
  ReferenceLine line;
  line.law = linear(e, k);
  line.spheres = {{r, m0, 0.45e-3, 0.0}, {r, m1, 1.35e-3, 0.0}};
  line.gravity = g;
  line.lower_wall = 0.0;
  line.upper_wall = 1.8e-3;
  std::vector<double> times;
  for (int n = 0; n <= 100; ++n) times.push_back(5e-5 * n);
  const auto run = reference_line(line, times);
  ASSERT_TRUE(run.events.empty());
  const double zeta = damping_ratio(e);
  const auto damping = [&](double m) { return 2.0 * zeta * std::sqrt(k * m); };
  const double c0 = damping(m0), c1 = damping(m0 * m1 / (m0 + m1)), c2 = damping(m1);
  // The unit of time is 1/ω, so that the matrix is well scaled.
  const double omega = std::sqrt(k / m1);
  Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
  a(0, 2) = a(1, 3) = 1.0;
  a.row(2) << -2.0 * k / m0, k / m0, -(c0 + c1) / m0, c1 / m0;
  a.row(3) << k / m1, -2.0 * k / m1, c1 / m1, -(c1 + c2) / m1;
  a.bottomLeftCorner<2, 2>() /= omega * omega;
  a.bottomRightCorner<2, 2>() /= omega;
  const Eigen::EigenSolver<Eigen::Matrix4d> modes(a);
  // Displacements from where the overlaps are .05, .1 and .05 mm; there the springs pull by 0.05 mm k on each sphere.
  const Eigen::Vector4d rest = a.fullPivLu().solve(
      Eigen::Vector4d(0.0, 0.0, g + (0.1e-3 - 0.05e-3) * k / m0, g + (0.05e-3 - 0.1e-3) * k / m1) / (omega * omega));
  const Eigen::Vector4cd amplitudes = modes.eigenvectors().fullPivLu().solve((-rest).cast<std::complex<double>>());
  for (const auto& state : run.samples) {
    const Eigen::Vector4cd phases = (modes.eigenvalues() * (omega * state.time)).array().exp() * amplitudes.array();
    const Eigen::Vector4d y = rest + (modes.eigenvectors() * phases).real();
    EXPECT_NEAR(state.position[0], 0.45e-3 + y(0), 1e-14);
    EXPECT_NEAR(state.position[1], 1.35e-3 + y(1), 1e-14);
    EXPECT_NEAR(state.velocity[0], omega * y(2), 1e-10);
    EXPECT_NEAR(state.velocity[1], omega * y(3), 1e-10);
  }
}

ReferenceImpact oblique(const ReferenceLaw& law, double degrees, double speed = 3.9) {
  ReferenceImpact impact;
  impact.law = law;
  impact.radius = radius;
  impact.mass = 4000.0 * 4.0 / 3.0 * pi * radius * radius * radius;
  impact.normal_speed = speed * std::cos(degrees * pi / 180.0);
  impact.tangential_velocity = speed * std::sin(degrees * pi / 180.0);
  return impact;
}

TEST(ReferenceImpact, FrictionlessKeepsTheTangentialMotion) {
  for (const ReferenceLaw& law : {linear(1.0), hertz(1.0), hertz(0.5)}) {
    ReferenceImpact impact = oblique(law, 30.0);
    impact.spin = 100.0;
    const auto last = reference_impact(impact, {1e-2}).samples.back();
    EXPECT_NEAR(last.velocity_z / impact.normal_speed, law.restitution, 1e-9);
    EXPECT_NEAR(last.velocity_x, impact.tangential_velocity, 1e-14);
    EXPECT_NEAR(last.x, 1e-2 * impact.tangential_velocity, 1e-12);
    EXPECT_NEAR(last.spin, 100.0, 1e-12);
  }
}

// Chung & Ooi (2011), test 4. The tensile part of the normal force has no friction: e of the closed form then is that
// of the compressive impulse, which differs from e only where the force changes sign.
TEST(ReferenceImpact, SlidesGrossly) {
  struct Case {
    double degrees, ratio, spin;
  };
  for (const Case& reference : {Case{40.0, 0.7829, 544.2}, Case{60.0, 0.8948, 355.2}}) {
    ReferenceLaw law = hertz(0.98);
    law.friction = 0.092;
    law.mindlin_damping = 0.0;
    const ReferenceImpact impact = oblique(law, reference.degrees);
    const auto run = reference_impact(impact, {1e-4});
    const auto& last = run.samples.back();
    const double v_n = impact.normal_speed, v_t = impact.tangential_velocity;
    const auto tension = states_at(run, Kind::tension_start);
    ASSERT_EQ(tension.size(), 1U);
    const double impulse = 1.0 + tension[0].velocity_z / v_n;
    EXPECT_NEAR(last.velocity_z / v_n, 0.98, 1e-9);
    EXPECT_NEAR(last.velocity_x / v_t, reference.ratio, 5e-5);
    EXPECT_NEAR(last.spin, reference.spin, 0.05);
    // The spring takes some 1e-8 s to reach the limit.
    EXPECT_NEAR(last.velocity_x / v_t, 1.0 - 0.092 * impulse * v_n / v_t, 2e-6);
    EXPECT_NEAR(last.spin / reference.spin, 2.5 * 0.092 * impulse * v_n / (radius * reference.spin), 1e-5);
  }
}

// Without any dashpot the sphere slides from the first instant to the last.
TEST(ReferenceImpact, SlidesGrosslyWhenElastic) {
  for (ReferenceLaw law : {linear(1.0, 1e7), hertz(1.0)}) {
    law.tangential_stiffness = 0.8 * law.stiffness;
    law.friction = 0.092;
    const ReferenceImpact impact = oblique(law, 60.0);
    const auto last = reference_impact(impact, {1e-3}).samples.back();
    const double change = 2.0 * 0.092 * impact.normal_speed;
    EXPECT_NEAR(last.velocity_x / impact.tangential_velocity, 1.0 - change / impact.tangential_velocity, 1e-10);
    EXPECT_NEAR(last.spin * radius / change, 2.5, 1e-9);
  }
}

// e = 1, c_t = 0, no limit: m_t dv_t/dt = −k_t ξ with 1/m_t = 1/m + r²/I = 7/(2 m), for half a period of the normal
// oscillator.
TEST(ReferenceImpact, SticksAsAnOscillator) {
  for (double ratio : {2.0 / 7.0, 0.8, 1.0}) {
    ReferenceLaw law = linear(1.0);
    law.tangential_stiffness = ratio * law.stiffness;
    law.friction = 1e12;
    ReferenceImpact impact = oblique(law, 40.0);
    impact.spin = -300.0;
    const double m = impact.mass, duration = pi * std::sqrt(m / law.stiffness);
    const double omega = std::sqrt(3.5 * law.tangential_stiffness / m);
    const double slip = impact.tangential_velocity - impact.spin * radius;
    const auto run = reference_impact(impact, {0.3 * duration, 2.0 * duration});
    const double t = 0.3 * duration;
    EXPECT_NEAR(run.samples[0].spring * omega / slip, std::sin(omega * t), 1e-9);
    EXPECT_NEAR((run.samples[0].velocity_x - run.samples[0].spin * radius) / slip, std::cos(omega * t), 1e-9);
    const double impulse = m / 3.5 * slip * (std::cos(omega * duration) - 1.0);
    EXPECT_NEAR(run.samples[1].velocity_x / slip, (impact.tangential_velocity + impulse / m) / slip, 1e-9);
    EXPECT_NEAR(run.samples[1].spin * radius / slip, (impact.spin - impulse / (0.4 * m * radius)) * radius / slip,
                1e-9);
    EXPECT_NEAR(states_at(run, Kind::contact_end)[0].time / duration, 1.0, 1e-9);
  }
}

// e = 1, c_t = 0: slides from the start if k_t v_t > μ k_n v_n, and until cos ω t has fallen to
// κ (v_t − 3.5 μ v_n)/(μ v_n (1 − 3.5 κ)), κ = k_t/k_n, if that is met; then swings back and slides again.
TEST(ReferenceImpact, SlidesThenSticksThenSlidesBack) {
  ReferenceLaw law = linear(1.0);
  const double ratio = 0.8, friction = 0.3;
  law.tangential_stiffness = ratio * law.stiffness;
  law.friction = friction;
  const ReferenceImpact impact = oblique(law, 25.0);
  const double v_n = impact.normal_speed, v_t = impact.tangential_velocity;
  const auto run = reference_impact(impact, {1e-2});
  ASSERT_EQ(run.events.size(), 5U);
  EXPECT_EQ(run.events[1].kind, Kind::sliding_start);
  EXPECT_EQ(run.events[2].kind, Kind::sticking_start);
  EXPECT_LT(run.events[2].state.tangential_force, 0.0);
  EXPECT_EQ(run.events[3].kind, Kind::sliding_start);
  EXPECT_GT(run.events[3].state.tangential_force, 0.0);
  const double cosine = ratio * (v_t - 3.5 * friction * v_n) / (friction * v_n * (1.0 - 3.5 * ratio));
  const double omega = std::sqrt(law.stiffness / impact.mass);
  EXPECT_NEAR(std::cos(omega * run.events[2].state.time), cosine, 1e-9);
}

// The law as a soft-sphere code steps it: spring first, then the limit, then the motion.
struct Stepped {
  double velocity_x, velocity_z, spin;
};
Stepped step_impact(const ReferenceImpact& impact, double time_step) {
  const ReferenceLaw& law = impact.law;
  const double m = impact.mass, r = impact.radius, beta = damping_ratio(law.restitution);
  const bool is_hertz = law.kind == ReferenceLaw::Kind::hertz_mindlin;
  double overlap = 0.0, spring = 0.0;
  Stepped s{impact.tangential_velocity, -impact.normal_speed, impact.spin};
  do {
    overlap -= time_step * s.velocity_z;
    const double root = std::sqrt(r * std::max(overlap, 0.0)), factor = 2.0 * std::sqrt(5.0 / 6.0) * beta;
    const double k_t = is_hertz ? 8.0 * law.shear_modulus * root : law.tangential_stiffness;
    const double c_t = is_hertz ? law.mindlin_damping * factor * std::sqrt(k_t * m) : law.tangential_damping;
    const double c_n =
        is_hertz ? factor * std::sqrt(2.0 * law.modulus * root * m) : 2.0 * beta * std::sqrt(law.stiffness * m);
    const double k_n = is_hertz ? 4.0 / 3.0 * law.modulus * root : law.stiffness;
    double normal = k_n * overlap - c_n * s.velocity_z;
    if (law.cut_tension) normal = std::max(normal, 0.0);
    const double slip = s.velocity_x - s.spin * r, limit = law.friction * std::max(normal, 0.0);
    spring += time_step * slip;
    double tangential = -k_t * spring - c_t * slip;
    if (std::abs(tangential) > limit) {
      tangential = std::copysign(limit, tangential);
      if (k_t > 0.0) spring = -(tangential + c_t * slip) / k_t;
    }
    s.velocity_z += time_step * normal / m;
    s.velocity_x += time_step * tangential / m;
    s.spin -= time_step * tangential / (0.4 * m * r);
  } while (overlap > 0.0);
  return s;
}

// All regimes of Maw, Barber & Fawcett (1976), both laws, with and without dashpots: small steps of the discrete law
// come to the reference. Where the Mindlin dashpot alone exceeds the limit at first they do so only below 1e-6 of the
// contact's duration.
TEST(ReferenceImpact, IsTheLimitOfSmallSteps) {
  for (const bool is_hertz : {false, true})
    for (double e : {1.0, 0.7})
      for (double shear_damping : {0.0, 1.0})
        for (bool cut : {false, true})
          for (double degrees : {2.0, 10.0, 25.0, 40.0, 70.0})
            for (double spin : {0.0, -400.0}) {
              ReferenceLaw law = is_hertz ? hertz(e) : linear(e, 1e7);
              law.friction = 0.3;
              law.cut_tension = cut;
              law.tangential_stiffness = 0.8 * law.stiffness;
              law.mindlin_damping = shear_damping;
              ReferenceImpact impact = oblique(law, degrees);
              law.tangential_damping = shear_damping * damping_ratio(e) * std::sqrt(law.stiffness * impact.mass);
              impact.law = law;
              impact.spin = spin;
              const auto run = reference_impact(impact, {1e-4});
              const auto& last = run.samples.back();
              const double duration = states_at(run, Kind::contact_end)[0].time;
              const double steps = is_hertz && e < 1.0 && shear_damping > 0.0 ? 5e5 : 5e3;
              const Stepped coarse = step_impact(impact, duration / steps);
              const Stepped fine = step_impact(impact, duration / (4.0 * steps));
              const auto expect_limit = [&](double reference, double of_coarse, double of_fine) {
                EXPECT_NEAR(of_fine, reference, 1e-4) << is_hertz << " " << e << " " << degrees << " " << spin;
                EXPECT_LT(std::abs(of_fine - reference), 0.35 * std::abs(of_coarse - reference) + 3e-6);
              };
              expect_limit(last.velocity_x, coarse.velocity_x, fine.velocity_x);
              expect_limit(last.velocity_z, coarse.velocity_z, fine.velocity_z);
              expect_limit(last.spin * radius, coarse.spin * radius, fine.spin * radius);
            }
}

TEST(ReferenceContact, RefusesIllPosedProblems) {
  EXPECT_THROW(reference_bounce(linear(0.0), radius, mass, 9.81, 0.1, {1.0}), std::invalid_argument);
  EXPECT_THROW(reference_bounce(linear(0.9, 0.0), radius, mass, 9.81, 0.1, {1.0}), std::invalid_argument);
  EXPECT_THROW(reference_bounce(linear(0.9), radius, mass, 9.81, 0.1, {1.0, 0.5}), std::invalid_argument);
  EXPECT_THROW(reference_bounce(linear(0.9), radius, mass, 0.0, 0.1, {1.0}), std::invalid_argument);
  ReferenceLaw law = linear(0.9);
  law.friction = 0.3;
  EXPECT_THROW(reference_impact(oblique(law, 30.0), {1.0}), std::invalid_argument);
  ReferenceImpact impact = oblique(linear(0.9), 30.0);
  impact.spin = std::nan("");
  EXPECT_THROW(reference_impact(impact, {1.0}), std::runtime_error);  // from CVODE
}

}  // namespace
}  // namespace slfb::dem
