#include "solver/dem/packing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "correlations/materials.hpp"
#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/walls.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

dem::Engine engine_of(const Scene& scene, const Contact& contact) {
  return make_engine(contact, {dem::walls_of(scene).front()}, {scene.geometry.width[0], scene.geometry.width[1], 0.0},
                     1);
}

void add_weight(dem::Engine& engine, const Scene& scene) {
  for (std::size_t i = 0; i < engine.particles.size(); ++i)
    engine.external_force.z[i] =
        -gravitational_acceleration * (engine.particles.mass[i] - scene.liquid.density * engine.particles.volume(i));
}

double kinetic_energy(const dem::Particles& spheres) {
  double sum = 0.0;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (const double v : spheres.velocity.at(i)) sum += 0.5 * spheres.mass[i] * v * v;
  return sum;
}

/// Settles the spheres with safe steps until they rest, gives each a small random push and goes on with the step in
/// question, from the same place and with the same springs of friction.
TrialResult solve(const Scene& given, const Parameters& parameters, int replicate) {
  Scene scene = given;
  const double diameter = scene.species.front().diameter;
  scene.geometry.width = {4.0 * diameter, 4.0 * diameter};
  const double mass = scene.species.front().density * dem::Particles::volume_of(0.5 * diameter);
  const auto safe = [&](double stiffness, double restitution) {
    Contact contact = scene.contact;
    contact.integrator = Integrator::symplectic_euler;
    contact.stiffness = stiffness;
    contact.restitution = restitution;
    contact.time_step = 0.1 * std::sqrt(0.5 * mass / stiffness);
    return contact;
  };
  constexpr double push_speed = 1e-3;  // at most, in each direction [m/s]
  const double fall = std::sqrt(2.0 * 30.0 * diameter / gravitational_acceleration);
  // Soft springs do for the fall. The packing then finds its place with stiffer ones, ten times at most at once: the
  // energy of its overlaps would throw it up.
  double stiffness = std::min(scene.contact.stiffness, 1e3);
  auto stage = std::make_unique<dem::Engine>(engine_of(scene, safe(stiffness, 0.5)));
  for (const dem::PlacedSphere& sphere : dem::start_positions(scene))
    stage->add_particle(sphere.centre, 0.5 * diameter, scene.species.front().density, 0);
  add_weight(*stage, scene);
  stage->advance(static_cast<std::int64_t>(std::ceil(2.0 * fall / stage->time_step())));
  for (bool own = false; !own; stiffness = std::min(10.0 * stiffness, scene.contact.stiffness)) {
    own = stiffness == scene.contact.stiffness;
    auto next = std::make_unique<dem::Engine>(engine_of(scene, safe(stiffness, 0.1)));
    for (std::size_t i = 0; i < stage->particles.size(); ++i)
      next->add_particle(stage->particles.position.at(i), 0.5 * diameter, scene.species.front().density, 0);
    add_weight(*next, scene);
    const double rest = 1e-3 * 0.5 * mass * push_speed * push_speed * static_cast<double>(next->particles.size());
    constexpr int rounds_at_most = 20;
    for (int round = 0; round < rounds_at_most && (round == 0 || kinetic_energy(next->particles) > rest); ++round)
      next->advance(2000);
    stage = std::move(next);
  }

  const dem::Engine& settled = *stage;
  dem::Engine engine = engine_of(scene, scene.contact);
  for (std::size_t i = 0; i < settled.particles.size(); ++i)
    engine.add_particle(settled.particles.position.at(i), 0.5 * diameter, scene.species.front().density, 0);
  add_weight(engine, scene);
  engine.step();  // from which the integrator's own memory comes
  auto memory = settled.memory();
  memory.integrator = engine.memory().integrator;
  dem::Particles spheres = settled.particles;
  std::mt19937_64 generator(static_cast<unsigned>(replicate) + 1);
  const auto push = [&] { return push_speed * (static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0); };
  for (auto* component : {&spheres.velocity.x, &spheres.velocity.y, &spheres.velocity.z})
    for (double& v : *component) v = push();
  engine.restore(std::move(spheres), memory);
  const double pushed = kinetic_energy(engine.particles);
  const double start = thread_cpu_seconds();
  const auto steps = static_cast<std::int64_t>(parameters.at("steps"));
  double limit = 0.0;
  for (std::int64_t step = 0; step < steps; step += 100) {
    engine.advance(100);
    if (step == 0) limit = 2.0 / std::sqrt(engine.network_frequency_squared());
  }
  double after = 0.0;
  for (int sample = 0; sample < 20; ++sample) {
    engine.step();
    after += kinetic_energy(engine.particles) / 20.0;
  }
  TrialResult result;
  result.values["energy"].value = after / pushed;
  result.values["network_limit"].value = limit;
  result.counts["particle-steps"] = static_cast<double>(engine.particles.size()) * static_cast<double>(steps);
  result.cpu_seconds = thread_cpu_seconds() - start;
  return result;
}

}  // namespace

Problem packing_problem() {
  return {"packing",
          "A settled packing in water, each sphere given a push of at most 1 mm/s: does its motion die out?",
          "run",
          "numerics/studies/scenes/box.toml",
          {{"energy", "kinetic energy over that of the push", "-"},
           {"network_limit", "2/ω of the contact network (Gershgorin's bound)", "s"}},
          {{"steps", 4000.0}},
          solve};
}

}  // namespace slfb::studies
