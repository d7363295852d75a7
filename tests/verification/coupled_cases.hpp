// What the tests of spheres and liquid together share.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/walls.hpp"
#include "solver/fluid/prescribed_liquid.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/user_law.hpp"
#include "tests/verification/liquid_cases.hpp"

namespace slfb {

/// Water in a box with periodic sides, where nothing but the spheres disturbs the flow; U_L upwards.
inline Scene periodic_box(double width, double height, int cells_across, double velocity) {
  Scene scene;
  scene.geometry.shape = Shape::box;
  scene.geometry.width = {width, width};
  scene.geometry.height = height;
  scene.liquid = {998.2, 1e-3, velocity};
  scene.fluid.wall = LateralBoundary::periodic;
  scene.fluid.cells_across = cells_across;
  scene.fluid.cell_height = width / cells_across;
  scene.fluid.time_step = 1e-3;
  scene.fluid.pressure_tolerance = 1e-12;
  scene.species = {{"sphere", 0.005, 2230.0, 1}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  scene.coupling.own_volume = OwnVolume::counted;  // the plain exchange; lone_spheres_test.cpp has the other
  return scene;
}

/// Spheres and liquid of a scene. Without walls the spheres go where they want; a test puts them.
struct CoupledCase {
  explicit CoupledCase(Scene of, std::vector<dem::Wall> walls = {})
      : scene(std::move(of)), engine(make_engine(scene.contact, std::move(walls), {0.0, 0.0, 0.0}, 1)) {
    liquid = solved_liquid(scene);
    if (!liquid) prescribed = std::make_unique<fluid::PrescribedLiquid>(scene, scene.liquid.superficial_velocity);
    fluid::Liquid& any = liquid ? static_cast<fluid::Liquid&>(*liquid) : *prescribed;
    exchange = std::make_unique<coupling::PhaseCoupling>(scene, any, find_drag_law(scene.coupling.drag_law));
  }
  // The parts refer to one another.
  CoupledCase(const CoupledCase&) = delete;
  CoupledCase& operator=(const CoupledCase&) = delete;

  std::size_t add(const std::array<double, 3>& centre, const std::array<double, 3>& velocity = {},
                  const std::array<double, 3>& spin = {}) {
    const Species& species = scene.species.front();
    const std::size_t i = engine.add_particle(centre, 0.5 * species.diameter, species.density, 0);
    engine.particles.velocity.x[i] = velocity[0];
    engine.particles.velocity.y[i] = velocity[1];
    engine.particles.velocity.z[i] = velocity[2];
    engine.particles.angular_velocity.x[i] = spin[0];
    engine.particles.angular_velocity.y[i] = spin[1];
    engine.particles.angular_velocity.z[i] = spin[2];
    return i;
  }

  void step() {
    exchange->advance(engine, scene.fluid.time_step);
    engine.advance(std::llround(scene.fluid.time_step / scene.contact.time_step));
  }
  void run(double seconds) {
    for (auto k = std::llround(seconds / scene.fluid.time_step); k > 0; --k) step();
  }

  Scene scene;
  std::unique_ptr<fluid::StaggeredLiquid> liquid;       ///< none in the quiescent tier
  std::unique_ptr<fluid::PrescribedLiquid> prescribed;  ///< only in the quiescent tier
  dem::Engine engine;
  std::unique_ptr<coupling::PhaseCoupling> exchange;
};

}  // namespace slfb
