#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "solver/dem/engine.hpp"
#include "solver/laws/make_engine.hpp"

/// What the tests of few spheres in contact share.
namespace slfb::dem {

inline constexpr std::array all_integrators{Integrator::symplectic_euler, Integrator::velocity_verlet,
                                            Integrator::position_verlet, Integrator::gear};

inline const char* name_of(Integrator integrator) {
  return std::array{"symplectic Euler", "velocity Verlet", "position Verlet",
                    "Gear"}[static_cast<std::size_t>(integrator)];
}

inline const Wall floor_at_zero{Wall::Kind::plane, 2, 1.0, 0.0};

struct Sphere {
  Vec3 centre, velocity, spin;
  double radius, density;
};

inline Engine engine_with(const Contact& contact, std::vector<Wall> walls, const std::vector<Sphere>& spheres) {
  Engine engine = make_engine(contact, std::move(walls), {0, 0, 0}, 1);
  const auto set = [](VectorField& field, std::size_t i, Vec3 value) {
    field.x[i] = value.x;
    field.y[i] = value.y;
    field.z[i] = value.z;
  };
  for (const Sphere& s : spheres) {
    const std::size_t i = engine.add_particle({s.centre.x, s.centre.y, s.centre.z}, s.radius, s.density, 0);
    set(engine.particles.velocity, i, s.velocity);
    set(engine.particles.angular_velocity, i, s.spin);
  }
  return engine;
}

inline Vec3 at(const VectorField& field, std::size_t i) { return {field.x[i], field.y[i], field.z[i]}; }
inline Vec3 vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// The order at which errors fall that belong to doubled numbers of steps: the mean slope from the first to the last.
inline double order_of(const std::vector<double>& errors) {
  return std::log2(std::abs(errors.front() / errors.back())) / static_cast<double>(errors.size() - 1);
}

}  // namespace slfb::dem
