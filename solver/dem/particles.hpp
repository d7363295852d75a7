#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

#include "solver/support/vec3.hpp"

namespace slfb::dem {

/// Three components stored apart, so that loops over particles run over contiguous memory.
struct VectorField {
  std::vector<double> x, y, z;
  void resize(std::size_t n, double value = 0.0) {
    x.resize(n, value);
    y.resize(n, value);
    z.resize(n, value);
  }
  void set_zero() {
    x.assign(x.size(), 0.0);
    y.assign(y.size(), 0.0);
    z.assign(z.size(), 0.0);
  }
  void erase(std::size_t i) {
    for (auto* component : {&x, &y, &z}) component->erase(component->begin() + static_cast<std::ptrdiff_t>(i));
  }
  [[nodiscard]] std::array<double, 3> at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  [[nodiscard]] Vec3 vector(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, Vec3 value) { x[i] = value.x, y[i] = value.y, z[i] = value.z; }
};

/// State and properties of all spheres, structure of arrays, SI units.
struct Particles {
  VectorField position;            ///< [m]
  VectorField velocity;            ///< [m/s]
  VectorField angular_velocity;    ///< [rad/s]
  std::vector<double> radius;      ///< [m]
  std::vector<double> mass;        ///< [kg]
  std::vector<double> added_mass;  ///< of liquid that is accelerated with the sphere [kg]
  std::vector<int> species;        ///< index into Scene::species

  [[nodiscard]] std::size_t size() const { return radius.size(); }

  /// Appends a sphere at rest and returns its index.
  std::size_t add(const std::array<double, 3>& centre, double sphere_radius, double density, int species_index) {
    const std::size_t i = size();
    for (auto* field : {&position, &velocity, &angular_velocity}) field->resize(i + 1);
    position.x[i] = centre[0];
    position.y[i] = centre[1];
    position.z[i] = centre[2];
    radius.push_back(sphere_radius);
    mass.push_back(density * volume_of(sphere_radius));
    added_mass.push_back(0.0);
    species.push_back(species_index);
    return i;
  }

  void remove(std::size_t i) {
    for (auto* field : {&position, &velocity, &angular_velocity}) field->erase(i);
    radius.erase(radius.begin() + static_cast<std::ptrdiff_t>(i));
    mass.erase(mass.begin() + static_cast<std::ptrdiff_t>(i));
    added_mass.erase(added_mass.begin() + static_cast<std::ptrdiff_t>(i));
    species.erase(species.begin() + static_cast<std::ptrdiff_t>(i));
  }

  [[nodiscard]] double volume(std::size_t i) const { return volume_of(radius[i]); }
  /// What resists acceleration along a line [kg].
  [[nodiscard]] double inertial_mass(std::size_t i) const { return mass[i] + added_mass[i]; }
  /// Moment of inertia of a solid sphere, 2/5 m r² [kg m²].
  [[nodiscard]] double inertia(std::size_t i) const { return 0.4 * mass[i] * radius[i] * radius[i]; }

  static constexpr double volume_of(double r) { return 4.0 / 3.0 * std::numbers::pi * r * r * r; }
};

}  // namespace slfb::dem
