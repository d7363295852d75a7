#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "correlations/materials.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/figures.hpp"
#include "reports/gnuplot.hpp"
#include "solver/dem/contact_reference.hpp"
#include "solver/dem/engine.hpp"
#include "solver/laws/make_engine.hpp"

namespace slfb {
namespace {

const FigureFolder folder{"numerics/frontier/integrators"};

/// The linear law has no scale of its own. So slow an impact keeps the overlap, 5e-7 radii, from shortening the lever
/// arm of the friction, which the reference takes as the radius.
constexpr double radius = 0.0025, density = 2230.0, speed = 1e-5;
/// Where in a step a contact begins and ends is chance: every number of steps per contact is taken with four fractions,
/// each with 64 starts.
constexpr int phases = 64;
constexpr std::array fractions{0.125, 0.375, 0.625, 0.875};

struct Impact {
  const char* name;
  const char* title;
  double restitution, friction, tangential_velocity, spin;
};

constexpr std::array impacts{
    Impact{"elastic", "head-on, e = 1", 1.0, 0.0, 0.0, 0.0}, Impact{"damped", "head-on, e = 0.9", 0.9, 0.0, 0.0, 0.0},
    Impact{"oblique", "oblique, e = 0.9, μ = 0.3", 0.9, 0.3, 1.5 * speed, -0.5 * speed / radius}};

struct Method {
  Integrator integrator;
  const char* name;
};

constexpr std::array methods{Method{Integrator::symplectic_euler, "symplectic Euler"},
                             Method{Integrator::velocity_verlet, "velocity Verlet"},
                             Method{Integrator::position_verlet, "position Verlet"}, Method{Integrator::gear, "Gear"}};

constexpr std::array steps_per_contact{5, 7, 10, 14, 20, 30, 50, 70, 100, 200, 400, 800, 1600};

Contact contact_of(const Impact& impact) {
  Contact contact;
  contact.stiffness = 1e4;
  contact.restitution = impact.restitution;
  contact.sliding_friction = impact.friction;
  return contact;
}

dem::ReferenceImpactState reference(const Impact& impact, double mass, double after) {
  const Contact contact = contact_of(impact);
  dem::ReferenceImpact problem;
  problem.law.stiffness = contact.stiffness;
  problem.law.restitution = contact.restitution;
  problem.law.friction = contact.sliding_friction;
  problem.law.tangential_stiffness = contact.tangential_stiffness_ratio * contact.stiffness;
  problem.law.tangential_damping = contact.tangential_damping_ratio * 2.0 * dem::damping_ratio(contact.restitution) *
                                   std::sqrt(contact.stiffness * mass);
  problem.radius = radius;
  problem.mass = mass;
  problem.normal_speed = speed;
  problem.tangential_velocity = impact.tangential_velocity;
  problem.spin = impact.spin;
  return dem::reference_impact(problem, {after}).samples.back();
}

struct Outcome {
  double mean_square_root, largest;  ///< error over impact speed [-]
  double cpu_nanoseconds;            ///< per sphere and contact
};

/// Half periods that the swing is followed; not a whole number, after which some errors cancel.
constexpr double half_periods = 5.3;

/// A sphere swings about its rest on the wall without losing contact: the exact solution is a
/// cosine, the force smooth.
Outcome swing(const Method& method, int steps) {
  const Contact still = contact_of(impacts[0]);
  const double mass = density * dem::Particles::volume_of(radius), frequency = std::sqrt(still.stiffness / mass);
  const double rest = mass * gravitational_acceleration / still.stiffness, amplitude = 0.5 * rest;
  double cpu = 0.0, sum = 0.0, largest = 0.0;
  for (const double fraction : fractions) {
    Contact contact = still;
    contact.integrator = method.integrator;
    contact.time_step = std::numbers::pi / frequency / (steps + fraction);
    dem::Engine engine = make_engine(contact, {{dem::Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
    const auto exact = [&](int k, double time) {
      const double angle = frequency * time + 2.0 * std::numbers::pi * k / phases;
      return std::pair{radius - rest + amplitude * std::cos(angle), -amplitude * frequency * std::sin(angle)};
    };
    for (int k = 0; k < phases; ++k) {
      const auto [height, velocity] = exact(k, 0.0);
      const std::size_t i = engine.add_particle({4.0 * radius * k, 0.0, height}, radius, density, 0);
      engine.particles.velocity.z[i] = velocity;
      engine.external_force.z[i] = -mass * gravitational_acceleration;
    }
    const std::clock_t start = std::clock();
    const auto last = std::llround(half_periods * steps);
    engine.advance(last);
    cpu += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    for (int k = 0; k < phases; ++k) {
      const auto [height, velocity] = exact(k, static_cast<double>(last) * contact.time_step);
      const auto i = static_cast<std::size_t>(k);
      const double error = std::hypot((engine.particles.position.z[i] - height) / amplitude,
                                      (engine.particles.velocity.z[i] - velocity) / (amplitude * frequency));
      sum += error * error;
      largest = std::max(largest, error);
    }
  }
  constexpr double spheres = phases * static_cast<double>(fractions.size());
  return {std::sqrt(sum / spheres), largest, 1e9 * cpu / (half_periods * spheres)};
}

/// Many spheres far apart strike the wall, each at another part of a step.
Outcome strike(const Impact& impact, const Method& method, int steps, const dem::ReferenceImpactState& truth,
               double contact_time) {
  double cpu = 0.0, sum = 0.0, largest = 0.0;
  for (const double fraction : fractions) {
    Contact contact = contact_of(impact);
    contact.integrator = method.integrator;
    contact.time_step = contact_time / (steps + fraction);
    dem::Engine engine = make_engine(contact, {{dem::Wall::Kind::plane, 2, 1.0, 0.0}}, {0, 0, 0}, 1);
    for (int k = 0; k < phases; ++k) {
      const double gap = speed * contact.time_step * (1.0 + (k + 0.5) / phases);
      const std::size_t i = engine.add_particle({4.0 * radius * k, 0.0, radius + gap}, radius, density, 0);
      engine.particles.velocity.x[i] = impact.tangential_velocity;
      engine.particles.velocity.z[i] = -speed;
      engine.particles.angular_velocity.y[i] = impact.spin;
    }
    const std::clock_t start = std::clock();
    engine.advance(steps + steps / 4 + 5);
    cpu += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    for (std::size_t i = 0; i < engine.particles.size(); ++i) {
      const auto v = engine.particles.velocity.at(i);
      const double squared = std::pow(v[0] - truth.velocity_x, 2) + std::pow(v[2] - truth.velocity_z, 2) +
                             std::pow(radius * (engine.particles.angular_velocity.y[i] - truth.spin), 2);
      sum += squared;
      largest = std::max(largest, std::sqrt(squared));
    }
  }
  constexpr double spheres = phases * static_cast<double>(fractions.size());
  return {std::sqrt(sum / spheres) / speed, largest / speed, 1e9 * cpu / spheres};
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"frontier-integrators",
                      {},
                      folder.caption(),
                      {"CPU times are measured anew at each drawing, beside whatever else the machine does."}};
  const double mass = density * dem::Particles::volume_of(radius);
  std::vector<std::string> names, titles, method_titles;
  for (const Method& method : methods) method_titles.emplace_back(method.name);
  const auto add_case = [&](const std::string& name, const std::string& title, auto outcome_of) {
    names.push_back(name);
    titles.push_back(title);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      DataTable table{fmt::format("frontier-integrators_{}_{}", name, m),
                      {"force evaluations per contact [-]", "root mean square of the relative error [-]", "largest [-]",
                       "CPU time per sphere and contact [ns]"},
                      {}};
      for (const int steps : steps_per_contact) {
        const Outcome outcome = outcome_of(methods[m], steps);
        table.rows.push_back(
            {static_cast<double>(steps), outcome.mean_square_root, outcome.largest, outcome.cpu_nanoseconds});
      }
      output.data.push_back(write_csv(table, context.out));
    }
  };
  add_case("swing", "in lasting contact", [](const Method& method, int steps) { return swing(method, steps); });
  for (const Impact& impact : impacts) {
    const double contact_time =
        dem::LinearSpringDashpot::contact_time(contact_of(impact).stiffness, impact.restitution, mass);
    const auto truth = reference(impact, mass, 1.5 * contact_time);
    add_case(impact.name, impact.title,
             [&](const Method& method, int steps) { return strike(impact, method, steps, truth, contact_time); });
  }
  PlotValues values;
  values.markups("cases", names);
  values.markups("case_title", titles);
  values.texts("methods", method_titles);
  draw_plot("frontier-integrators", folder.plot(), values, {1240, 640}, context.out);
  return output;
}

}  // namespace

Figure frontier_integrators() {
  return {"frontier-integrators", folder.title(), no_runs, draw, folder.path().string()};
}

}  // namespace slfb
