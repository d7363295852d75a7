#include "experiments/peng_2014/probes.hpp"

#include <array>
#include <cmath>
#include <filesystem>

#include "correlations/materials.hpp"
#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/walls.hpp"
#include "solver/fluid/liquid.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

constexpr std::array<double, 3> unbounded{0.0, 0.0, 0.0};

std::size_t add_bed_sphere(dem::Engine& engine, const Scene& scene, const std::array<double, 3>& centre) {
  const Species& bed = scene.species.front();
  return engine.add_particle(centre, 0.5 * bed.diameter, bed.density, 0);
}

double restitution(const Scene& scene) {
  constexpr double speed = 0.1;
  const double d = scene.species.front().diameter;
  dem::Engine engine = make_engine(scene.contact, {}, unbounded, 1);
  add_bed_sphere(engine, scene, {-0.505 * d, 0.0, 0.0});
  add_bed_sphere(engine, scene, {0.505 * d, 0.0, 0.0});
  engine.particles.velocity.x = {0.5 * speed, -0.5 * speed};
  const auto apart = [&] {
    return engine.particles.velocity.x[1] > 0.0 &&
           engine.particles.position.x[1] - engine.particles.position.x[0] > 1.005 * d;
  };
  while (!apart()) engine.step();
  return (engine.particles.velocity.x[1] - engine.particles.velocity.x[0]) / speed;
}

double sliding_friction(const Scene& scene) {
  constexpr double speed = 0.5, seconds = 0.01;  // it would roll after 2 speed/(7 µ g) = 0.05 s
  const double r = 0.5 * scene.species.front().diameter;
  dem::Engine engine = make_engine(scene.contact, {{dem::Wall::Kind::plane, 2, 1.0, 0.0}}, unbounded, 1);
  add_bed_sphere(engine, scene, {0.0, 0.0, r});
  const double weight = engine.particles.mass[0] * gravitational_acceleration;
  engine.external_force.z[0] = -weight;
  const auto steps = [&](double time) { return std::llround(time / engine.time_step()); };
  engine.advance(steps(1.0));  // the floor carries it
  engine.particles.velocity.x[0] = speed;
  engine.advance(steps(seconds));  // the tangential spring winds up
  const double before = engine.particles.velocity.x[0];
  const auto measured = steps(seconds);
  engine.advance(measured);
  return (before - engine.particles.velocity.x[0]) /
         (gravitational_acceleration * static_cast<double>(measured) * engine.time_step());
}

double terminal_velocity(Scene scene) {
  scene.fluid.tier = FluidTier::quiescent;
  dem::Engine engine = make_engine(scene.contact, {}, unbounded, 1);
  add_bed_sphere(engine, scene, {0.0, 0.0, 0.0});
  scene.liquid.superficial_velocity = 0.0;
  const auto liquid = fluid::make_liquid(scene);
  coupling::PhaseCoupling exchange(scene, *liquid, find_drag_law(scene.coupling.drag_law));
  const auto substeps = std::llround(scene.fluid.time_step / scene.contact.time_step);
  for (auto k = std::llround(3.0 / scene.fluid.time_step); k > 0; --k) {
    exchange.advance(engine, scene.fluid.time_step);
    engine.advance(substeps);
  }
  return -engine.particles.velocity.z[0];
}

double frozen_bed_gradient(Scene scene) {
  scene.fluid.tier = FluidTier::one_dimensional;
  scene.geometry = {Shape::box, 0.0, {0.024, 0.024}, 0.24};
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cells_across = 1;
  scene.fluid.cell_height = 0.012;
  scene.liquid.superficial_velocity = 0.05;
  dem::Engine engine = make_engine(scene.contact, {}, unbounded, 1);
  const double spacing = 0.006;  // 1.2 diameters of 5 mm, and whole lattice layers per cell
  for (double z = 0.5 * spacing; z < scene.geometry.height; z += spacing)
    for (double y = -0.009; y < 0.012; y += spacing)
      for (double x = -0.009; x < 0.012; x += spacing) add_bed_sphere(engine, scene, {x, y, z});
  const auto liquid = fluid::make_liquid(scene);
  coupling::PhaseCoupling exchange(scene, *liquid, find_drag_law(scene.coupling.drag_law));
  // The spheres do not move: a few steps bring the liquid to rest in time.
  for (int step = 0; step < 5; ++step) exchange.advance(engine, scene.fluid.time_step);
  const auto layers = liquid->pressure().size();
  return (liquid->pressure().front() - liquid->pressure().back()) /
         (scene.fluid.cell_height * static_cast<double>(layers - 1));
}

}  // namespace

Measurements measure_probes(const Scene& scene) {
  const auto exact = [](double value, const char* unit) { return Measurement{value, 0.0, 1, unit, "solver"}; };
  return {{MeasureKey{"restitution", "solver"}, exact(restitution(scene), "-")},
          {MeasureKey{"sliding_friction", "solver"}, exact(sliding_friction(scene), "-")},
          {MeasureKey{"terminal_velocity", "solver"}, exact(terminal_velocity(scene), "m/s")},
          {MeasureKey{"frozen_bed_gradient", "solver"}, exact(frozen_bed_gradient(scene), "Pa/m")}};
}

Measurements measure_probes() {
  return measure_probes(load_scene(source_folder() / "experiments/peng_2014/scenes/6in5W.toml"));
}

}  // namespace slfb
