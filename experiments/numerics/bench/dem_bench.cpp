#include "experiments/numerics/bench/dem_bench.hpp"

#include <Random123/philox.h>
#include <fmt/core.h>
#include <fmt/os.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "correlations/materials.hpp"
#include "experiments/numerics/bench/sphere_file.hpp"
#include "solver/dem/packing.hpp"
#include "solver/laws/make_engine.hpp"

namespace slfb::bench {
namespace {

constexpr double density = 2230.0, cylinder_diameter = 0.05, box_width = 0.2, gas_solids_fraction = 0.4,
                 gas_speed = 0.1, stiffness = 1e4;

bool is_gas(const DemScene& scene) { return scene.letter == 'C'; }

/// Edge of the cube that holds the gas [m].
double gas_edge(const DemScene& scene) {
  const double volume = static_cast<double>(scene.particles) * dem::Particles::volume_of(0.5 * scene.diameter);
  return std::cbrt(volume / gas_solids_fraction);
}

/// Geometry and spheres in the words of a scene, for the packing and the walls.
Scene column(const DemScene& bench) {
  Scene scene;
  const bool box = bench.letter == 'D';
  scene.geometry.shape = box ? Shape::box : Shape::cylinder;
  scene.geometry.diameter = cylinder_diameter;
  scene.geometry.width = {box_width, box_width};
  scene.geometry.height = 1.0;
  scene.species = {{"glass", bench.diameter, density, static_cast<std::int64_t>(bench.particles)}};
  scene.outlet.rule = OutletRule::remove;  // no lid
  return scene;
}

Contact contact_of(const DemScene& scene) {
  Contact contact;
  contact.stiffness = stiffness;
  contact.restitution = is_gas(scene) ? 1.0 : 0.9;
  contact.sliding_friction = is_gas(scene) ? 0.0 : 0.3;
  contact.time_step = scene.time_step;
  return contact;
}

dem::Engine empty_engine(const DemScene& scene, const Contact& contact, int threads) {
  if (!is_gas(scene)) return make_engine(contact, dem::walls_of(column(scene)), {0.0, 0.0, 0.0}, threads);
  const double edge = gas_edge(scene);
  return make_engine(contact, {}, {edge, edge, edge}, threads);
}

void add_weight(dem::Engine& engine) {
  for (std::size_t i = 0; i < engine.particles.size(); ++i)
    engine.external_force.z[i] = -gravitational_acceleration * engine.particles.mass[i];
}

/// Settles a loose packing with little rebound: first with soft contacts, which allow long steps, then with the scene's
/// stiffness until that has come to rest too.
dem::Particles settle(const DemScene& scene, int threads) {
  dem::Particles state;
  for (const dem::PlacedSphere& sphere : dem::start_positions(column(scene)))
    state.add(sphere.centre, 0.5 * scene.diameter, density, 0);
  for (const bool soft : {true, false}) {
    Contact contact = contact_of(scene);
    contact.restitution = 0.3;
    if (soft) contact.stiffness = 1e3, contact.time_step = 5e-5;
    dem::Engine engine = empty_engine(scene, contact, threads);
    for (std::size_t i = 0; i < state.size(); ++i)
      engine.add_particle(state.position.at(i), 0.5 * scene.diameter, density, 0);
    add_weight(engine);
    engine.advance(std::llround((soft ? 0.35 : 0.05) / contact.time_step));
    state = engine.particles;
  }
  return state;
}

/// A simple cubic lattice with random velocities, left to melt.
dem::Particles melt(const DemScene& scene, int threads) {
  dem::Engine engine = empty_engine(scene, contact_of(scene), threads);
  const double edge = gas_edge(scene);
  const auto sites = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(scene.particles))));
  const double spacing = edge / static_cast<double>(sites);
  const auto coordinate = [&](std::size_t k) { return (static_cast<double>(k) + 0.5) * spacing - 0.5 * edge; };
  for (std::size_t i = 0; i < scene.particles; ++i)
    engine.add_particle({coordinate(i % sites), coordinate(i / sites % sites), coordinate(i / sites / sites)},
                        0.5 * scene.diameter, density, 0);
  dem::VectorField& velocity = engine.particles.velocity;
  const double mean_square = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < scene.particles; ++i) {
      const auto bits = r123::Philox4x64()({{i, 0, 0, 0}}, {{1, 0}});
      const auto uniform = [&](std::size_t k) { return static_cast<double>(bits[k] >> 11) * 0x1.0p-52 - 1.0; };
      velocity.x[i] = uniform(0), velocity.y[i] = uniform(1), velocity.z[i] = uniform(2);
      sum += velocity.x[i] * velocity.x[i] + velocity.y[i] * velocity.y[i] + velocity.z[i] * velocity.z[i];
    }
    return sum / static_cast<double>(scene.particles);
  }();
  for (auto* component : {&velocity.x, &velocity.y, &velocity.z})
    for (double& value : *component) value *= gas_speed / std::sqrt(mean_square);
  engine.advance(10000);
  return engine.particles;
}

}  // namespace

const std::vector<DemScene>& dem_scenes() {
  static const std::vector<DemScene> scenes{
      {'A', "3600 spheres of 5 mm settled in a cylinder of 50 mm", 3600, 0.005, 5e-5, 1000, 4000},
      {'B', "16666 spheres of 3 mm settled in a cylinder of 50 mm", 16666, 0.003, 2e-5, 1000, 1000},
      {'C', "3600 spheres of 5 mm, elastic and frictionless at 0.1 m/s r.m.s., voidage 0.6 in a periodic cube", 3600,
       0.005, 5e-5, 1000, 10000},
      {'D', "200000 spheres of 3 mm settled in a box 0.2 m wide", 200000, 0.003, 2e-5, 100, 100}};
  return scenes;
}

dem::Engine prepare(const DemScene& scene, int threads, const std::filesystem::path& cache,
                    const std::function<void(const std::string&)>& say) {
  const auto file = cache / fmt::format("{}_v{}_spheres.h5", scene.letter, numerics_version);
  dem::Particles state;
  if (std::filesystem::exists(file)) {
    state = load_spheres(file);
  } else {
    say(fmt::format("preparing scene {} ({}), once", scene.letter, scene.description));
    state = is_gas(scene) ? melt(scene, threads) : settle(scene, threads);
    save_spheres(file, state);
  }
  dem::Engine engine = empty_engine(scene, contact_of(scene), threads);
  for (std::size_t i = 0; i < scene.particles; ++i)
    engine.add_particle(state.position.at(i), 0.5 * scene.diameter, density, 0);
  engine.particles.velocity = state.velocity;
  engine.particles.angular_velocity = state.angular_velocity;
  if (!is_gas(scene)) add_weight(engine);
  return engine;
}

double DemTiming::median_rate() const {
  std::vector<double> sorted = rates;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

double DemTiming::nanoseconds_per_contact() const { return 1e9 / (median_rate() * 0.5 * contacts_per_particle); }

DemTiming time_dem(const DemScene& scene, dem::Engine& engine, int repetitions, std::int64_t steps) {
  using Clock = std::chrono::steady_clock;
  const auto particles = static_cast<double>(engine.particles.size());
  engine.advance(scene.warm_up);
  DemTiming timing{scene, engine.threads(), {}, 0.0, 0.0, 0.0};
  const std::int64_t builds = engine.list_builds();
  for (int r = 0; r < repetitions; ++r) {
    const auto start = Clock::now();
    engine.advance(steps);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    timing.rates.push_back(particles * static_cast<double>(steps) / seconds);
    for (std::size_t i = 0; i < engine.particles.size(); ++i) timing.contacts_per_particle += engine.contacts(i);
    timing.pairs_per_particle += static_cast<double>(engine.listed_pairs());
  }
  timing.contacts_per_particle /= particles * repetitions;
  timing.pairs_per_particle /= particles * repetitions;
  timing.list_builds_per_step =
      static_cast<double>(engine.list_builds() - builds) / (static_cast<double>(steps) * repetitions);
  return timing;
}

void write_lammps(const DemScene& scene, const dem::Engine& engine, const std::filesystem::path& file) {
  const dem::Particles& p = engine.particles;
  const double half = 0.5 * (is_gas(scene) ? gas_edge(scene) : scene.letter == 'D' ? box_width : cylinder_diameter);
  const double bottom = is_gas(scene) ? -half : 0.0;
  const double top = is_gas(scene) ? half : *std::max_element(p.position.z.begin(), p.position.z.end()) + 0.05;
  auto out = fmt::output_file(file.string());
  out.print("scene {} of slfb bench dem, SI units\n\n{} atoms\n1 atom types\n", scene.letter, p.size());
  out.print("{0:.17g} {1:.17g} xlo xhi\n{0:.17g} {1:.17g} ylo yhi\n{2:.17g} {3:.17g} zlo zhi\n", -half, half, bottom,
            top);
  out.print("\nAtoms # sphere\n\n");
  for (std::size_t i = 0; i < p.size(); ++i)
    out.print("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, 2.0 * p.radius[i], density, p.position.x[i],
              p.position.y[i], p.position.z[i]);
  out.print("\nVelocities\n\n");
  for (std::size_t i = 0; i < p.size(); ++i)
    out.print("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, p.velocity.x[i], p.velocity.y[i],
              p.velocity.z[i], p.angular_velocity.x[i], p.angular_velocity.y[i], p.angular_velocity.z[i]);
}

}  // namespace slfb::bench
