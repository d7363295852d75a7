#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/dem/engine.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

/// The linear law has no scale of its own; so slow an impact keeps the overlap far below the radius.
constexpr double speed = 1e-5;
/// Where in a step a contact begins is chance: spheres that begin at evenly spread parts of it.
constexpr int phases = 64;
/// And where it ends: steps per contact with these fractions.
constexpr std::array fractions{0.125, 0.375, 0.625, 0.875};

/// Sum of squared deviations from an exact answer.
struct Deviation {
  double exact, sum = 0.0, squares = 0.0;
  double n = 0.0;
  void add(double value) {
    sum += value;
    squares += (value - exact) * (value - exact);
    ++n;
  }
  [[nodiscard]] TrialValue result() const { return {sum / n, std::sqrt(squares / n), exact}; }
};

TrialResult solve(const Scene& scene, const Parameters& parameters, int) {
  const Species& sphere = scene.species.front();
  const double radius = 0.5 * sphere.diameter, mass = sphere.density * dem::Particles::volume_of(radius);
  const Contact& given = scene.contact;
  const double contact_time = dem::LinearSpringDashpot::contact_time(given.stiffness, given.restitution, mass);
  const double zeta = dem::damping_ratio(given.restitution), root = std::sqrt(1.0 - zeta * zeta);
  Deviation restitution{given.restitution}, duration{contact_time},
      overlap{speed / std::sqrt(given.stiffness / mass) * std::exp(-zeta / root * std::atan2(root, zeta))};

  std::vector<double> time_steps;
  if (parameters.at("steps_per_contact") > 0.0)
    for (const double fraction : fractions)
      time_steps.push_back(contact_time / (parameters.at("steps_per_contact") + fraction));
  else
    time_steps.push_back(given.time_step);

  double cpu = 0.0, evaluations = 0.0;
  for (const double time_step : time_steps) {
    Contact contact = given;
    contact.time_step = time_step;
    const auto with_spheres = [&] {
      dem::Engine engine = make_engine(contact, {{dem::Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
      for (int k = 0; k < phases; ++k) {
        const double gap = speed * time_step * (1.0 + (k + 0.5) / phases);
        const std::size_t i = engine.add_particle({4.0 * radius * k, 0.0, radius + gap}, radius, sphere.density, 0);
        engine.particles.velocity.z[i] = -speed;
      }
      return engine;
    };
    const auto steps = static_cast<std::int64_t>(std::ceil(1.3 * contact_time / time_step)) + 5;
    // The fastest of several: others use the machine too.
    double fastest = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 5; ++round) {
      dem::Engine timed = with_spheres();
      const double start = thread_cpu_seconds();
      timed.advance(steps);
      fastest = std::min(fastest, thread_cpu_seconds() - start);
    }
    cpu += fastest;

    dem::Engine watched = with_spheres();
    std::array<double, phases> deepest{}, touching{};
    for (std::int64_t step = 0; step < steps; ++step) {
      watched.step();
      for (int k = 0; k < phases; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double depth = radius - watched.particles.position.z[i];
        deepest[i] = std::max(deepest[i], depth);
        if (depth > 0.0) touching[i] += time_step;
      }
    }
    for (std::size_t i = 0; i < phases; ++i) {
      restitution.add(watched.particles.velocity.z[i] / speed);
      duration.add(touching[i]);
      overlap.add(deepest[i]);
    }
    evaluations += contact_time / time_step;
  }
  const auto cases = static_cast<double>(time_steps.size());
  TrialResult result;
  result.values = {
      {"restitution", restitution.result()}, {"contact_time", duration.result()}, {"peak_overlap", overlap.result()}};
  result.values["restitution_error"].value = result.values["restitution"].error;
  result.counts = {{"force evaluations", evaluations / cases}};
  result.cpu_seconds = cpu / (cases * phases);
  return result;
}

}  // namespace

Problem impact_problem() {
  return {
      "impact",
      "A sphere strikes a plane wall head-on, with 64 different starts within a step; exact: the damped oscillator.",
      "contact",
      "numerics/studies/scenes/sphere.toml",
      {{"restitution", "restitution", "-"},
       {"contact_time", "contact time", "s"},
       {"peak_overlap", "peak overlap", "m"},
       {"restitution_error", "error of the speed after an impact over that before", "-"}},
      {{"steps_per_contact", 0.0}},  // 0: the step of the scene
      solve};
}

}  // namespace slfb::studies
