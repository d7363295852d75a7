#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "solver/dem/cell_search.hpp"
#include "solver/dem/collision_statistics.hpp"
#include "solver/dem/contact_law.hpp"
#include "solver/dem/integrators.hpp"
#include "solver/dem/lubrication.hpp"
#include "solver/dem/particles.hpp"
#include "solver/dem/walls.hpp"

namespace slfb::dem {

struct PairList;         // see engine_internals.hpp
struct ThreadPartition;  // see engine_internals.hpp

/// The motion can no longer be computed; what() says which sphere, where and when.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A contact and what it remembers: all that must be kept over a rebuilt list or a checkpoint.
struct ContactRecord {
  std::uint32_t first, second;  ///< spheres; at a wall the sphere and the number of the wall
  Vec3 spring;                  ///< tangential, as the first sphere sees it [m]
  Vec3 rolling_memory;          ///< of the elastic-plastic rolling resistance, on the first sphere [N m]
  std::uint32_t first_step;     ///< number of the step (modulo 2^32) in which the contact began
  double impact_speed;          ///< normal approach speed in that step [m/s]
};

/// Soft-sphere discrete element method (Peng 2014, Eqs. 16-19).
///
/// Each step is one sweep over the spheres in the order of a cell grid. For a block of spheres: find the touching pairs
/// i < j, compute them a few at a time in vector registers, add each force to i and j, then move the block, whose
/// forces are complete: no later pair needs its positions. Each thread owns a contiguous partition of that order; pairs
/// that reach into a later partition are computed before all others, and their forces are added at the point of the sum
/// that they have in a single sweep. So every sum has the same order at any number of threads, and because the order
/// comes from positions alone, however the spheres are numbered.
class Engine {
 public:
  /// `law`: the law that contact.law names (make_engine() in solver/laws looks it up). `period`: extent of a periodic
  /// box around the origin in x, y and z, 0 where the domain is not periodic [m]. `threads`: 1 or more.
  Engine(const Contact& contact, const ContactLawKernels& law, std::vector<Wall> walls, std::array<double, 3> period,
         int threads);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) = delete;

  /// From now on the liquid between nearly touching spheres, and walls, resists their approach. Its forces count among
  /// those of contacts. Must be called before the first sphere is added.
  void lubricate(const Lubrication& lubrication) { lubrication_ = lubrication; }
  /// While there is no liquid yet: whether lubricate() has no effect for now.
  void suspend_lubrication(bool suspended) { lubrication_suspended_ = suspended; }

  /// The state. Between calls of advance() callers may change positions, velocities and added masses; radii and masses
  /// only before the first. Spheres are added and removed by the functions below alone.
  Particles particles;
  VectorField external_force;  ///< on each sphere, constant over a call of advance() [N]; sized by add_particle()

  /// A sphere at rest. `centre` and `radius` [m], `density` [kg/m³], `species`: index into Scene::species.
  /// Returns its number, which is the number of spheres before.
  std::size_t add_particle(const std::array<double, 3>& centre, double radius, double density, int species);
  /// The spheres behind i move up by one number. `i` must be less than particles.size().
  void remove_particle(std::size_t i);

  /// Advances all spheres by `steps` time steps of the scene; does nothing for `steps` ≤ 0.
  /// Throws EngineError in the step in which a sphere's centre has gone through a wall or another sphere's surface, or
  /// in which a velocity is not finite any more; `particles` then holds the state of that step.
  void advance(std::int64_t steps);
  void step() { advance(1); }

  // Numbers of spheres below must be less than particles.size(). "Last step": 0 where there was none.

  /// Mean force of the other spheres and the walls on i over the last advance(), from the change of its momentum [N].
  [[nodiscard]] std::array<double, 3> mean_solid_force(std::size_t i) const { return mean_solid_force_.at(i); }
  /// Follows one sphere: mean_contact_force_of_tracked() is then kept.
  void track(std::optional<std::size_t> i) { tracked_ = i; }
  /// Mean force of the other spheres on the tracked one over the last advance() [N].
  [[nodiscard]] std::array<double, 3> mean_contact_force_of_tracked() const { return mean_tracked_force_; }

  /// Force of the other spheres on i at the last step [N].
  [[nodiscard]] std::array<double, 3> contact_force(std::size_t i) const { return components(contact_force_, i); }
  /// Force of the walls on i at the last step [N].
  [[nodiscard]] std::array<double, 3> wall_force(std::size_t i) const { return components(wall_force_, i); }
  /// Upward forces of the bottom (wall number 0) and of all other walls on the spheres, mean over the last advance()
  /// with the weights that the integrator gives to each step: times its duration, the momentum that they gave [N].
  struct VerticalWallForces {
    double bottom = 0.0, others = 0.0;
  };
  [[nodiscard]] VerticalWallForces mean_vertical_wall_forces() const;
  /// Spheres in contact with i at the last step [-].
  [[nodiscard]] int contacts(std::size_t i) const { return contacts_[i]; }
  /// Contacts with other spheres that have begun since i was added [-].
  [[nodiscard]] std::int64_t contact_events(std::size_t i) const { return contact_events_[i]; }
  /// True if i touches wall number `wall`.
  [[nodiscard]] bool touches_wall(std::size_t i, std::size_t wall) const;
  /// Largest overlap over the smaller radius at the last step [-].
  [[nodiscard]] double maximum_overlap() const { return maximum_overlap_; }

  /// Share of the smaller radius above which an overlap is deep: the spheres no longer act as spheres that touch.
  static constexpr double deep_overlap = 0.2;
  /// A contact with a deep overlap.
  struct DeepContact {
    double share = 0.0;        ///< overlap over the smaller radius [-]
    std::uint32_t first = 0;   ///< sphere
    std::uint32_t second = 0;  ///< sphere, or number of the wall
    bool at_wall = false;
    Vec3 place;  ///< centre of the first sphere [m]
  };
  /// The deepest of all steps since the last call, if any contact was deep.
  [[nodiscard]] std::optional<DeepContact> take_deepest_contact();

  struct TouchingPair {
    std::uint32_t first, second;  ///< spheres; at a wall the sphere and the number of the wall
    bool at_wall;
    double normal_force;      ///< compressive positive [N]
    double tangential_force;  ///< magnitude [N]
  };
  /// All contacts of the last step.
  [[nodiscard]] std::vector<TouchingPair> touching_pairs() const;
  /// Whether each collision between spheres that ends from now on is kept until take_collisions().
  void collect_collisions(bool on);
  /// Finished collisions since the last call, in the order of their ends.
  std::vector<Collision> take_collisions();

  /// Upper bound 2 Σ_j k_ij/m_i over all spheres i of the squared frequencies of the contact network at the last step
  /// (Gershgorin; springs of the normals) [1/s²]. Explicit steps are stable below Δt = 2/ω without damping.
  [[nodiscard]] double network_frequency_squared() const;

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] double time_step() const { return time_step_; }
  [[nodiscard]] int threads() const { return threads_; }
  /// How often the neighbour list was built, and its pairs of spheres: for tuning.
  [[nodiscard]] std::int64_t list_builds() const { return list_builds_; }
  [[nodiscard]] std::size_t listed_pairs() const;

  /// Everything beyond the particles that the next step depends on, for checkpoints.
  struct Memory {
    std::vector<ContactRecord> contacts, wall_contacts;
    std::vector<std::int64_t> contact_events;
    VectorField mean_solid_force;
    VectorField list_position;          ///< positions when the neighbour list was built
    double skin = 0.0;                  ///< of that list [m]
    double travel = 0.0, margin = 0.0;  ///< bound of the displacement since the list was last checked, its limit [m]
    std::int64_t list_step = 0, steps = 0;
    std::vector<double> integrator;  ///< the integrator's memory: x, y, z of each vector, sphere by sphere
  };
  [[nodiscard]] Memory memory() const;
  /// Goes on from a checkpoint of an engine with the same scene: every later step is the same, bit by bit.
  /// Throws EngineError if the integrator of that engine was another one.
  void restore(Particles state, const Memory& memory);

 private:
  /// Start: forces without motion. Final: the last of a call of advance(), after which much is asked for.
  enum class StepMode { start, middle, final };
  struct SecondBody;
  struct Records {
    std::vector<ContactRecord> spheres, walls;
  };

  void resize_particle_arrays();
  void integrator_memory_by_number();
  [[nodiscard]] bool moved_by_caller(std::size_t slot) const;
  /// Slots are far apart in memory when the spheres are visited by their numbers: asks for those of a later one.
  template <class... Columns>
  void fetch_ahead(std::size_t i, const Columns&... columns) const {
    constexpr std::size_t ahead = 12;
    if (i + ahead >= slot_of_.size()) return;
    const std::size_t s = slot_of_[i + ahead];
    (__builtin_prefetch(&columns[s], 1), ...);
  }
  void pack();
  void unpack(std::int64_t steps);

  [[nodiscard]] double largest_displacement() const;
  [[nodiscard]] double choose_skin() const;
  void rebuild_from_particles(const Records& records, std::optional<double> skin = {});
  void list_pairs(double skin);
  void rebuild_when_needed();
  void rebuild();
  [[nodiscard]] Records contact_records() const;
  void restore_contacts(const Records& records);

  template <class Work>
  void for_partitions(Work work);
  void one_step(StepMode mode);
  void add_lubrication();
  std::size_t find_touching(const PairList& list, std::uint32_t first, std::uint32_t last,
                            std::uint32_t* touching) const;
  template <bool AtWall, class Second, class Take>
  void compute(PairList& list, const std::uint32_t* touching, std::size_t count, ThreadPartition& partition,
               StepMode mode, Second second, Take take) const;
  template <class Take>
  void compute_pairs(PairList& list, const std::uint32_t* touching, std::size_t count, ThreadPartition& partition,
                     StepMode mode, Take take) const;
  void compute_walls(ThreadPartition& partition, StepMode mode);
  void compute_outer(ThreadPartition& partition, StepMode mode);
  void add_earlier_partitions(const ThreadPartition& partition);
  void sweep(ThreadPartition& partition, StepMode mode);
  /// Notes the deep overlaps among the first `size` contacts of a batch, which belong to the pairs `touching`.
  template <bool AtWall>
  void note_deep_overlaps(const PairList& list, const std::uint32_t* touching, std::size_t size,
                          ThreadPartition& partition) const;
  template <class Integrator>
  void move(ThreadPartition& partition, std::size_t first, std::size_t last, StepMode mode);
  template <class Integrator>
  void predict(std::size_t first, std::size_t last);
  template <class Integrator>
  void integrate_wall_forces(StepMode mode);
  template <class Integrator>
  void choose_integrator();
  [[noreturn]] void fail(const char* what, std::size_t slot) const;
  [[nodiscard]] std::uint32_t now() const { return static_cast<std::uint32_t>(steps_ + 1); }

  [[nodiscard]] std::array<double, 3> components(const std::vector<Vec4>& by_slot, std::size_t i) const {
    if (i >= slot_of_.size()) return {};  // nothing has moved yet
    const Vec4& vector = by_slot[slot_of_[i]];
    return {vector.x, vector.y, vector.z};
  }
  template <class Visit>
  void for_contacts(Visit visit) const;
  void finish_collision(ThreadPartition& partition, PairList& list, std::uint32_t p) const;
  void finish_collisions();

  Contact contact_, wall_contact_;
  std::vector<Wall> walls_;
  std::array<double, 3> period_;
  double time_step_;
  int threads_;
  bool periodic_;
  ContactLawKernels law_;
  std::size_t rolling_, wall_rolling_;  ///< index of the rolling resistance among the kernels, of pairs and at walls
  bool rolling_remembers_;              ///< whether it carries something from step to step
  // The instances of the templates that this scene's integrator needs.
  void (Engine::*move_)(ThreadPartition&, std::size_t, std::size_t, StepMode) = nullptr;
  void (Engine::*predict_)(std::size_t, std::size_t) = nullptr;
  void (Engine::*integrate_wall_forces_)(StepMode) = nullptr;  ///< none where the mean over the steps is exact
  double spring_phase_ = 1.0;

  // By slot: spheres in the order of the cell grid.
  CellSearch search_;
  std::vector<std::uint32_t> order_, slot_of_;  ///< number of the sphere in a slot, and back
  std::vector<Vec4> position_;                  ///< centre [m]; w: radius [m]
  std::vector<Vec4> velocity_;                  ///< [m/s]; w: 1/m [1/kg]
  std::vector<Vec4> angular_velocity_;          ///< [rad/s]; w: 1/I [1/(kg m²)]
  std::vector<Vec4> force_, torque_;            ///< of contacts with spheres and walls, zero between steps [N], [N m]
  std::vector<Vec4> wall_force_;                ///< of walls at the last step [N]
  std::vector<Vec4> contact_force_;             ///< of other spheres at the last step [N]
  std::vector<Vec4> vertical_wall_force_;       ///< Σ of F_z over the steps of advance(): x bottom, y other walls [N]
  std::vector<Vec4> external_acceleration_;     ///< by the external force [m/s²]
  std::vector<Vec4> list_position_;             ///< centres when the list was built [m]
  std::vector<Vec4> integrator_memory_;         ///< integrator_size_ vectors for each sphere
  std::vector<std::int64_t> events_;            ///< contacts that have begun
  std::vector<int> touched_;                    ///< spheres in contact at the last step of advance()
  std::size_t integrator_size_ = 0;
  std::vector<Vec4> vector_scratch_;
  std::vector<std::uint32_t> number_scratch_;
  std::vector<std::int64_t> count_scratch_;
  std::array<Vec4, 27> image_shift_{};
  std::vector<std::unique_ptr<ThreadPartition>> partitions_;
  bool list_valid_ = false;
  double skin_ = 0.0;
  double travel_ = 0.0, margin_ = 0.0;  ///< bound of the largest displacement since it was last measured, and its limit
  std::int64_t list_step_ = 0, list_builds_ = 0, steps_ = 0, last_advance_ = 0;

  /// The vertical forces of the bottom, and of the other walls, as the integrator sums them: that of a body of mass 1.
  struct WallImpulse {
    Vec4 position, velocity, angular_velocity;
    std::array<Vec4, 6> memory;
    double force_so_far = 0.0;  ///< part of vertical_wall_force_ that is dealt with [N]
  };
  std::array<WallImpulse, 2> wall_impulse_;

  // By number of the sphere.
  VectorField mean_solid_force_;
  std::vector<int> contacts_;
  std::vector<std::int64_t> contact_events_;
  std::optional<std::size_t> tracked_;
  std::size_t tracked_slot_ = 0;
  Vec3 tracked_sum_;
  std::array<double, 3> mean_tracked_force_{};
  double maximum_overlap_ = 0.0;
  bool collect_collisions_ = false;
  std::optional<Lubrication> lubrication_;
  bool lubrication_suspended_ = false;
};

}  // namespace slfb::dem
