#include "experiments/numerics/studies/coupled_bed.hpp"

#include "solver/dem/packing.hpp"
#include "solver/dem/walls.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::studies {

CoupledBed::CoupledBed(const Scene& scene, const dem::Particles& spheres, int threads)
    : scene_(scene),
      engine(make_engine(scene_.contact, dem::walls_of(scene_), {0.0, 0.0, 0.0}, threads)),
      owned_liquid_(fluid::make_liquid(scene_, threads)),
      liquid(*owned_liquid_),
      exchange(scene_, liquid, find_drag_law(scene_.coupling.drag_law)) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Species& species = scene_.species[static_cast<std::size_t>(spheres.species[i])];
    engine.add_particle(spheres.position.at(i), spheres.radius[i], species.density, spheres.species[i]);
  }
  engine.particles.velocity = spheres.velocity;
  engine.particles.angular_velocity = spheres.angular_velocity;
}

Scene glass_bed() {
  Scene scene;
  scene.geometry.diameter = 0.05;
  scene.geometry.height = 0.6;
  scene.liquid = {998.2, 1e-3, 0.10};
  scene.fluid.cells_across = 8;
  scene.fluid.cell_height = 0.00625;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230.0, 3600}};
  scene.contact.stiffness = 1e3;
  scene.contact.rolling_friction = 0.0175;
  scene.contact.time_step = 1e-4;
  return scene;
}

dem::Particles fluidised(const Scene& scene, double seconds, int threads) {
  dem::Particles loose;
  for (const dem::PlacedSphere& sphere : dem::start_positions(scene)) {
    const Species& species = scene.species[static_cast<std::size_t>(sphere.species)];
    loose.add(sphere.centre, 0.5 * species.diameter, species.density, sphere.species);
  }
  CoupledBed bed(scene, loose, threads);
  bed.advance(seconds);
  return bed.engine.particles;
}

}  // namespace slfb::studies
