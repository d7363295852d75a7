#include "experiments/numerics/bench/sphere_file.hpp"

#include <string>
#include <utility>
#include <vector>

#include "solver/io/hdf5_file.hpp"

namespace slfb::bench {
namespace {

template <class Particles>
auto columns_of(Particles& particles) {
  return std::vector{std::pair{"position/x", &particles.position.x},
                     {"position/y", &particles.position.y},
                     {"position/z", &particles.position.z},
                     {"velocity/x", &particles.velocity.x},
                     {"velocity/y", &particles.velocity.y},
                     {"velocity/z", &particles.velocity.z},
                     {"angular_velocity/x", &particles.angular_velocity.x},
                     {"angular_velocity/y", &particles.angular_velocity.y},
                     {"angular_velocity/z", &particles.angular_velocity.z},
                     {"radius", &particles.radius},
                     {"mass", &particles.mass},
                     {"added_mass", &particles.added_mass}};
}

}  // namespace

void save_spheres(const std::filesystem::path& file, const dem::Particles& particles) {
  io::write_atomically(file, [&](io::Hdf5File& h5) {
    for (const auto& [name, values] : columns_of(particles)) h5.write(name, *values);
    h5.write("species", std::vector<std::int64_t>(particles.species.begin(), particles.species.end()));
  });
}

dem::Particles load_spheres(const std::filesystem::path& file) {
  const auto h5 = io::Hdf5File::open(file);
  dem::Particles particles;
  for (const auto& [name, values] : columns_of(particles)) *values = h5.read_doubles(name);
  for (const std::int64_t species : h5.read_integers("species")) particles.species.push_back(static_cast<int>(species));
  return particles;
}

}  // namespace slfb::bench
