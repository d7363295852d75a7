#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "experiments/numerics/studies/problems/problem_list.hpp"
#include "solver/dem/engine.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/support/processor.hpp"

namespace slfb::studies {
namespace {

constexpr int side = 6;
constexpr double temperature = 1e-3;  ///< Θ, as in a fluidised bed [m²/s²]

TrialResult solve(const Scene& scene, const Parameters& parameters, int replicate) {
  const Species& sphere = scene.species.front();
  const double radius = 0.5 * sphere.diameter, mass = sphere.density * dem::Particles::volume_of(radius);
  const double spacing = sphere.diameter * std::cbrt(std::numbers::pi / 6.0 / parameters.at("solids"));
  const double length = side * spacing;
  Contact contact = scene.contact;
  contact.restitution = 1.0;
  contact.sliding_friction = contact.rolling_friction = 0.0;
  dem::Engine engine = make_engine(contact, {}, {length, length, length}, 1);
  std::mt19937_64 generator(static_cast<unsigned>(replicate) + 1);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; };
  const auto site = [&](int k) { return (k + 0.5) * spacing - 0.5 * length; };
  for (int k = 0; k < side * side * side; ++k)
    engine.add_particle({site(k % side), site(k / side % side), site(k / side / side)}, radius, sphere.density, 0);
  auto& velocity = engine.particles.velocity;
  for (auto* component : {&velocity.x, &velocity.y, &velocity.z}) {
    for (double& v : *component) v = uniform();
    const auto n = static_cast<double>(component->size());
    const double mean = std::accumulate(component->begin(), component->end(), 0.0) / n;
    double squares = 0.0;
    for (double& v : *component) {
      v -= mean;
      squares += v * v;
    }
    for (double& v : *component) v *= std::sqrt(temperature * n / squares);
  }
  const auto energy = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < engine.particles.size(); ++i)
      for (const double v : velocity.at(i)) sum += 0.5 * mass * v * v;
    for (const auto& pair : engine.touching_pairs())
      sum += 0.5 * pair.normal_force * pair.normal_force / contact.stiffness;
    return sum;
  };
  const double start = thread_cpu_seconds();
  const double first = energy();
  const auto n = static_cast<double>(engine.particles.size());
  double events = 0.0, last = first;
  const double seconds_at_most = 20.0;
  while (events < parameters.at("collisions") * n &&
         static_cast<double>(engine.steps()) * contact.time_step < seconds_at_most && last < 10.0 * first) {
    engine.advance(50);
    events = 0.0;
    for (std::size_t i = 0; i < engine.particles.size(); ++i) events += static_cast<double>(engine.contact_events(i));
    last = energy();
  }
  TrialResult result;
  result.values["energy_change"].value = std::abs(last / first - 1.0);
  result.counts["particle-steps"] = n * static_cast<double>(engine.steps());
  result.cpu_seconds = thread_cpu_seconds() - start;
  return result;
}

}  // namespace

Problem gas_problem() {
  return {"gas",
          "216 smooth elastic spheres agitated as in a fluidised bed (Θ = 1e-3 m²/s²) in a periodic cube: their energy "
          "must not change.",
          "run",
          "numerics/studies/scenes/sphere.toml",
          {{"energy_change", "change of the energy over that at the start", "-"}},
          {{"solids", 0.45}, {"collisions", 20.0}},
          solve};
}

}  // namespace slfb::studies
