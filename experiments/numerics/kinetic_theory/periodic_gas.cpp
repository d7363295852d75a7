#include "experiments/numerics/kinetic_theory/periodic_gas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "correlations/collision/collision_laws.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/granular_temperature.hpp"
#include "solver/laws/make_engine.hpp"

namespace slfb::kinetic {
namespace {

constexpr double radius = 0.0025, density = 2230.0;
const double mass = density * dem::Particles::volume_of(radius);

Contact elastic(double stiffness, int steps_per_contact) {
  Contact contact;
  contact.stiffness = stiffness;
  contact.restitution = 1.0;
  contact.sliding_friction = 0.0;
  contact.time_step = dem::LinearSpringDashpot::contact_time(stiffness, 1.0, 0.5 * mass) / steps_per_contact;
  return contact;
}

}  // namespace

MeasuredFrequency measure_frequency(double solids, int side, double collisions) {
  constexpr int steps_per_contact = 20, stretches = 20, samples = 20;
  constexpr double contact_fraction = 0.004, temperature = 1e-3;
  const double spacing = 2.0 * radius * std::cbrt(std::numbers::pi / 6.0 / solids), length = spacing * side;
  const double expected = collision::Simonin1991{}(
      {solids, 2.0 * radius, 2.0 * radius, 1.5 * temperature, 0.0, collision::CarnahanStarling1969{}(solids)});
  const auto contact_lasting = [&](double fraction) {
    const double stiffness = 0.5 * mass * std::pow(std::numbers::pi * expected / fraction, 2);
    return elastic(stiffness, steps_per_contact);
  };
  const auto steps_for = [&](double per_sphere, const dem::Engine& engine) {
    return static_cast<std::int64_t>(per_sphere / expected / engine.time_step());
  };
  const auto set_temperature = [&](dem::Particles& particles) {
    const double scale = std::sqrt(1.5 * temperature / dem::fluctuating_energy(particles));
    for (auto* component : {&particles.velocity.x, &particles.velocity.y, &particles.velocity.z}) {
      const double mean = std::accumulate(component->begin(), component->end(), 0.0) / (side * side * side);
      for (double& u : *component) u = scale * (u - mean);
    }
  };

  dem::Engine melting = make_engine(contact_lasting(10.0 * contact_fraction), {}, {length, length, length}, 1);
  std::mt19937_64 generator(1);
  // Integers scaled by hand: the library's distributions differ between machines.
  const auto uniform = [](std::mt19937_64& bits) { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1.0; };
  const auto site = [&](int k) { return (k + 0.5) * spacing - 0.5 * length; };
  for (int k = 0; k < side * side * side; ++k) {
    const std::size_t i =
        melting.add_particle({site(k % side), site(k / side % side), site(k / side / side)}, radius, density, 0);
    melting.particles.velocity.x[i] = uniform(generator);
    melting.particles.velocity.y[i] = uniform(generator);
    melting.particles.velocity.z[i] = uniform(generator);
  }
  set_temperature(melting.particles);
  melting.advance(steps_for(20.0, melting));

  const Contact contact = contact_lasting(contact_fraction);
  dem::Engine engine = make_engine(contact, {}, {length, length, length}, 1);
  const std::size_t n = melting.particles.size();
  for (std::size_t i = 0; i < n; ++i) engine.add_particle(melting.particles.position.at(i), radius, density, 0);
  engine.particles.velocity = melting.particles.velocity;
  engine.advance(steps_for(5.0, engine));
  set_temperature(engine.particles);

  const auto events = [&] {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += engine.contact_events(i);
    return static_cast<double>(sum);
  };
  const auto energy = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto u = engine.particles.velocity.at(i);
      sum += 0.5 * mass * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }
    for (const auto& pair : engine.touching_pairs())
      sum += 0.5 * pair.normal_force * pair.normal_force / contact.stiffness;
    return sum;
  };
  engine.advance(1);
  const double first_energy = energy();
  MeasuredFrequency result{};
  std::vector<double> frequency;
  const std::int64_t steps = steps_for(collisions / (stretches * samples), engine);
  for (int stretch = 0; stretch < stretches; ++stretch) {
    const double before = events();
    double q2 = 0.0;
    for (int sample = 0; sample < samples; ++sample) {
      engine.advance(steps);
      q2 += dem::fluctuating_energy(engine.particles) / samples;
      result.energy_change = std::max(result.energy_change, std::abs(energy() / first_energy - 1.0));
    }
    const double per_time = (events() - before) / (static_cast<double>(n * samples * steps) * engine.time_step());
    frequency.push_back(per_time * 2.0 * radius / std::sqrt(q2));
    result.contact_fraction +=
        per_time * dem::LinearSpringDashpot::contact_time(contact.stiffness, 1.0, 0.5 * mass) / stretches;
  }
  for (double f : frequency) result.value += f / stretches;
  for (double f : frequency) result.error += (f - result.value) * (f - result.value) / (stretches * (stretches - 1.0));
  result.error = std::sqrt(result.error);
  return result;
}

}  // namespace slfb::kinetic
