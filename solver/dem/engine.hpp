#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "solver/dem/linear_spring_dashpot.hpp"
#include "solver/dem/neighbour_list.hpp"
#include "solver/dem/particles.hpp"
#include "solver/dem/walls.hpp"

namespace slfb::dem {

/// The motion has left what the method can follow; what() says which sphere, where and when.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A pair in contact and its tangential spring: what must be kept over a rebuilt list or a checkpoint.
struct ContactRecord {
  std::uint32_t first, second;
  Vec3 spring;
};

/// Soft-sphere discrete element method (Peng 2014, Eqs. 16-19) with symplectic Euler steps.
///
/// Pairs are computed once; each sphere then gathers its forces in a fixed order, so that the result is bitwise the
/// same at any number of threads.
class Engine {
 public:
  /// `period`: see NeighbourList::build.
  Engine(const Contact& contact, std::vector<Wall> walls, std::array<double, 3> period, int threads);

  Particles particles;
  VectorField external_force;  ///< on each sphere, constant over a step [N]; sized by add_particle

  std::size_t add_particle(const std::array<double, 3>& centre, double radius, double density, int species);
  void remove_particle(std::size_t i);

  /// Advances all spheres by one time step of the scene.
  void step();

  /// Starts a new averaging interval for the mean forces.
  void reset_mean_forces();
  /// Mean force of the other spheres on i since reset_mean_forces [N].
  [[nodiscard]] std::array<double, 3> mean_contact_force(std::size_t i) const;
  /// Mean force of the walls on i since reset_mean_forces [N].
  [[nodiscard]] std::array<double, 3> mean_wall_force(std::size_t i) const;

  /// Force of the other spheres on i at the last step [N].
  [[nodiscard]] std::array<double, 3> contact_force(std::size_t i) const { return contact_force_.at(i); }
  /// Spheres in contact with i at the last step [-].
  [[nodiscard]] int contacts(std::size_t i) const { return contacts_[i]; }
  /// New contacts of i with other spheres since it was added [-].
  [[nodiscard]] std::int64_t contact_events(std::size_t i) const { return contact_events_[i]; }
  /// True if i touches wall number `wall`.
  [[nodiscard]] bool touches_wall(std::size_t i, std::size_t wall) const;
  /// Largest overlap over the smaller radius at the last step [-].
  [[nodiscard]] double maximum_overlap() const { return maximum_overlap_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] double time_step() const { return time_step_; }
  [[nodiscard]] int threads() const { return threads_; }

  /// Everything beyond the particles that the next step depends on, for checkpoints.
  struct Memory {
    std::vector<ContactRecord> contacts;
    std::vector<double> wall_springs;  ///< three components per sphere and wall
    std::vector<std::int64_t> contact_events;
    VectorField mean_contact, mean_wall;  ///< running sums of the current averaging interval
    std::int64_t averaged_steps = 0, steps = 0;
  };
  [[nodiscard]] Memory memory() const;
  void restore(Particles state, const Memory& memory);

 private:
  template <bool Periodic>
  void compute_pairs(std::size_t first, std::size_t last);
  void compute_walls(std::size_t first, std::size_t last);
  void gather_and_move(std::size_t first, std::size_t last, double& displacement_squared);
  void rebuild(const std::vector<ContactRecord>& contacts);
  [[nodiscard]] std::vector<ContactRecord> contact_records() const;
  void resize_particle_arrays();
  [[noreturn]] void fail(const char* what, std::size_t i) const;

  LinearSpringDashpot law_;
  std::vector<Wall> walls_;
  std::array<double, 3> period_;
  double time_step_, steps_per_second_;
  int threads_;

  NeighbourList list_;
  bool list_valid_ = false;
  // One entry per pair of the list.
  std::vector<std::uint8_t> pair_state_;  ///< 0 apart, 1 in contact, 2 in contact since this step
  struct PairContact {
    Vec3 spring;            ///< tangential displacement ξ [m]
    Vec3 force;             ///< on the first sphere [N]
    Vec3 torque_on_second;  ///< [N m]
  };
  std::vector<PairContact> pair_;  ///< kept together: a contact touches two cache lines, not nine
  // What a pair needs of its second sphere, packed so that a random access touches one cache line each.
  struct alignas(32) Place {
    double x, y, z, radius;
  };
  struct alignas(64) Motion {
    Vec3 velocity, angular_velocity;
    double inertia;
    std::int64_t mass_class;  ///< index into masses_
  };
  void pack(std::size_t i);
  std::int64_t mass_class(double mass);
  std::vector<double> masses_;               ///< the distinct masses
  std::vector<double> root_effective_mass_;  ///< √(m_i m_j/(m_i + m_j)) for each pair of classes
  std::vector<std::int64_t> mass_class_;     ///< per sphere
  std::vector<Place> place_;
  std::vector<Motion> motion_;
  // One entry per sphere.
  VectorField contact_force_, wall_force_, torque_;
  std::vector<int> contacts_;
  std::vector<std::int64_t> contact_events_;
  VectorField mean_contact_, mean_wall_;
  std::vector<Vec3> wall_spring_;  ///< index sphere * walls + wall
  std::vector<double> overlap_;    ///< largest overlap over radius, per sphere
  double maximum_overlap_ = 0.0;
  std::int64_t averaged_steps_ = 0, steps_ = 0;
};

}  // namespace slfb::dem
