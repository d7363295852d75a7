#include "solver/run/model.hpp"

#include <array>
#include <cmath>

#include "solver/dem/packing.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::simulation {
namespace {

std::array<double, 3> period_of(const Scene& scene) {
  if (scene.geometry.shape != Shape::box || scene.fluid.wall != LateralBoundary::periodic) return {0.0, 0.0, 0.0};
  return {scene.geometry.width[0], scene.geometry.width[1], 0.0};
}

}  // namespace

Model::Model(const Scene& scene, int threads)
    : scene_(scene),
      engine_(make_engine(scene.contact, dem::walls_of(scene), period_of(scene), threads)),
      liquid_at_rest_(scene, 0.0),
      liquid_(fluid::make_liquid(scene, threads)),
      sphere_steps_(std::llround(scene.fluid.time_step / scene.contact.time_step)) {
  if (scene.coupling.lubrication_range > 0.0)
    engine_.lubricate({scene.liquid.viscosity, scene.coupling.lubrication_roughness, scene.coupling.lubrication_range});
  const drag::DragLawKernels drag_law = find_drag_law(scene.coupling.drag_law);
  resting_ = std::make_unique<coupling::PhaseCoupling>(scene, liquid_at_rest_, drag_law);
  flowing_ = std::make_unique<coupling::PhaseCoupling>(scene, *liquid_, drag_law);
}

void Model::fill() {
  for (const dem::PlacedSphere& sphere : dem::start_positions(scene_)) {
    const Species& species = scene_.species[static_cast<std::size_t>(sphere.species)];
    engine_.add_particle(sphere.centre, 0.5 * species.diameter, species.density, sphere.species);
  }
}

std::int64_t Model::advance(Surroundings surroundings) {
  engine_.suspend_lubrication(surroundings == Surroundings::nothing);
  if (surroundings == Surroundings::nothing) {
    const auto [x, y, z] = scene_.geometry.gravity();
    engine_.external_force.set_zero();
    for (std::size_t i = 0; i < particles().size(); ++i) {
      engine_.external_force.x[i] = x * particles().mass[i];
      engine_.external_force.z[i] = z * particles().mass[i];
    }
  } else {
    (surroundings == Surroundings::liquid ? flowing_ : resting_)->advance(engine_, scene_.fluid.time_step);
  }
  engine_.advance(sphere_steps_);
  return sphere_steps_ * static_cast<std::int64_t>(engine_.particles.size());
}

bool Model::has_room(const Species& species, double height) const {
  const double radius = 0.5 * species.diameter;
  const auto& position = particles().position;
  for (std::size_t i = 0; i < particles().size(); ++i)
    if (std::hypot(position.x[i], position.y[i], position.z[i] - height) < radius + particles().radius[i]) return false;
  return true;
}

void Model::release(const Species& species, double height) {
  dropped_ = engine_.add_particle({0.0, 0.0, height}, 0.5 * species.diameter, species.density,
                                  static_cast<int>(&species - scene_.species.data()));
  engine_.track(dropped_);
  flowing_->sphere_added();
}

bool Model::dropped_sphere_at_bottom() const { return dropped_ && engine_.touches_wall(*dropped_, 0); }

bool Model::dropped_sphere_above_top() const {
  return dropped_ && particles().position.z[*dropped_] >= scene_.geometry.height;
}

void Model::take_out_dropped() {
  engine_.remove_particle(*dropped_);
  flowing_->sphere_removed(*dropped_);
  dropped_.reset();
}

std::int64_t Model::remove_above_top() {
  std::int64_t removed = 0;
  for (std::size_t i = particles().size(); i-- > 0;) {
    if (particles().position.z[i] < scene_.geometry.height || i == dropped_) continue;
    engine_.remove_particle(i);
    flowing_->sphere_removed(i);
    if (dropped_ && *dropped_ > i) --*dropped_;
    ++removed;
  }
  return removed;
}

double Model::sphere_momentum() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < particles().size(); ++i) sum += particles().mass[i] * particles().velocity.z[i];
  return sum + flowing_->momentum_on_its_way(particles(), 2);
}

}  // namespace slfb::simulation
