#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <utility>

#include "correlations/materials.hpp"
#include "experiments/numerics/figures.hpp"
#include "reports/gnuplot.hpp"
#include "solver/dem/contact_reference.hpp"
#include "solver/dem/engine.hpp"
#include "solver/laws/make_engine.hpp"

namespace slfb {
namespace {

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
                      "",
                      {"CPU times are measured anew at each drawing, beside whatever else the machine does."}};
  output.caption =
      "Error against cost of the integrators of the particles' motion; 5 mm glass on a plane wall, 1e4 N/m. Left: a "
      "sphere swings about its rest for some periods and never loses contact; the exact solution is a cosine. Others: "
      "impacts, the truth being the trajectory by CVODE with event detection. Points: root mean square over 256 cases "
      "that begin and end at different parts of a step, from 5 to 1600 steps per contact. Grey: first and second "
      "order. The dotted line marks the 5.4 steps per contact of the paper's 5 mm glass. Above, the cost that no "
      "machine changes; below, the CPU time of this machine.";
  const double mass = density * dem::Particles::volume_of(radius);
  std::string upper, lower;
  const auto add_column = [&](const std::string& name, const std::string& title, auto outcome_of) {
    std::array<std::string, 2> plots;
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
      for (std::size_t row = 0; row < 2; ++row)
        plots[row] += fmt::format("{}'{}.csv' skip 1 using {}:2 with linespoints linestyle {} pointsize {} title '{}'",
                                  m == 0 ? "" : ", ", table.name, row == 0 ? 1 : 4, m + 2,
                                  1.15 - 0.25 * static_cast<double>(m), methods[m].name);
    }
    const bool first = upper.empty();
    upper += fmt::format(
        "set title '{}'\nplot {}, 0.5/x with lines linestyle 20 notitle, "
        "0.5/x**2 with lines linestyle 20 notitle\nunset key\nunset ylabel\n",
        title, plots[0]);
    lower += fmt::format("{}plot {}\nunset ylabel\n", first ? "set ylabel 'relative error [-]'\n" : "", plots[1]);
  };
  add_column("swing", "in lasting contact", [](const Method& method, int steps) { return swing(method, steps); });
  for (const Impact& impact : impacts) {
    const double contact_time =
        dem::LinearSpringDashpot::contact_time(contact_of(impact).stiffness, impact.restitution, mass);
    const auto truth = reference(impact, mass, 1.5 * contact_time);
    add_column(impact.name, impact.title,
               [&](const Method& method, int steps) { return strike(impact, method, steps, truth, contact_time); });
  }
  const std::string commands =
      "set multiplot layout 2,4 margins 0.06,0.985,0.11,0.93 spacing 0.045,0.15\n"
      "set logscale xy\nset format '10^{%L}'\nset yrange [1e-9:1]\nset ytics 1e2\nset key bottom left reverse Left "
      "samplen 1 font ',11'\nset xlabel 'force evaluations per contact'\nset xrange [4:5000]\n"
      "set arrow 1 from 5.4, graph 0 to 5.4, graph 1 nohead linestyle 20\nset ylabel 'relative error [-]'\n" +
      upper + "unset title\nunset arrow 1\nset xlabel 'CPU time per sphere and contact [ns]'\nset xrange [*:*]\n" +
      lower + "unset multiplot\n";
  draw_figure("frontier-integrators", commands, {1240, 640}, context.out);
  return output;
}

}  // namespace

Figure frontier_integrators() {
  return {"frontier-integrators", "Speed against accuracy: integrators of the particles' motion", no_runs, draw,
          "numerics/frontier/integrators"};
}

}  // namespace slfb
