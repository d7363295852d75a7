#include <algorithm>
#include <cmath>
#include <numbers>

#include "correlations/materials.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/dem/engine.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr int phases = 8;

TrialResult solve(const Scene& scene, const Parameters& parameters, int) {
  const Species& sphere = scene.species.front();
  const double radius = 0.5 * sphere.diameter, mass = sphere.density * dem::Particles::volume_of(radius);
  Contact contact = scene.contact;
  contact.restitution = 1.0;
  const double rest = mass * gravitational_acceleration / contact.stiffness,
               frequency = std::sqrt(contact.stiffness / mass);
  // A millionth of the rest overlap may grow a thousandfold without the sphere losing the wall.
  const double amplitude = 1e-6 * rest;
  dem::Engine engine = make_engine(contact, {{dem::Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
  for (int k = 0; k < phases; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / phases;
    const std::size_t i = engine.add_particle({4.0 * radius * k, 0.0, radius - rest + amplitude * std::cos(angle)},
                                              radius, sphere.density, 0);
    engine.particles.velocity.z[i] = -amplitude * frequency * std::sin(angle);
    engine.external_force.z[i] = -mass * gravitational_acceleration;
  }
  const double start = thread_cpu_seconds();
  const auto steps = static_cast<std::int64_t>(parameters.at("steps"));
  double largest = 0.0;
  for (std::int64_t step = 0; step < steps && largest < 1e3; ++step) {
    engine.step();
    for (std::size_t i = 0; i < phases; ++i)
      largest = std::max(largest, std::abs(engine.particles.position.z[i] - (radius - rest)) / amplitude);
  }
  TrialResult result;
  result.values["growth"].value = largest;
  result.counts["force evaluations"] = static_cast<double>(steps);
  result.cpu_seconds = (thread_cpu_seconds() - start) / phases;
  return result;
}

}  // namespace

Problem swing_problem() {
  return {"swing",
          "A sphere swings on a wall without damping and without losing contact: a harmonic oscillator.",
          "sphere",
          "numerics/studies/scenes/sphere.toml",
          {{"growth", "largest amplitude over the first", "-"}},
          {{"steps", 2000.0}},
          solve};
}

}  // namespace slfb::studies
