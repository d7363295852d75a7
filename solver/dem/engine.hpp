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

/// The motion has left what the method can follow; what() says which sphere, where and when.
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
/// forces are complete: no later pair needs its positions. Threads own contiguous shares of that order; pairs that
/// reach into a later share are computed before all else and added there first, in the place that they have in a
/// single sweep. So every sum has the same order at any number of threads, and because the order comes from positions
/// alone, however the spheres are numbered.
class Engine {
 public:
  /// `law` takes the place of the name in contact.law; make_engine() in solver/laws looks it up. `period`: extent of a
  /// periodic box around the origin in x, y and z, 0 where the domain is not periodic [m].
  Engine(const Contact& contact, const ContactLawKernels& law, std::vector<Wall> walls, std::array<double, 3> period,
         int threads);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) = delete;

  /// From now on the liquid between nearly touching spheres, and walls, resists their approach. Its forces count among
  /// those of contacts. To be called before the first sphere is added.
  void lubricate(const Lubrication& lubrication) { lubrication_ = lubrication; }

  Particles particles;         ///< may be changed between calls of advance(); masses and radii only before the first
  VectorField external_force;  ///< on each sphere, constant over a call of advance() [N]; sized by add_particle

  std::size_t add_particle(const std::array<double, 3>& centre, double radius, double density, int species);
  void remove_particle(std::size_t i);

  /// Advances all spheres by `steps` time steps of the scene.
  void advance(std::int64_t steps);
  void step() { advance(1); }

  /// Mean force of the other spheres and the walls on i over the last advance(), from the change of its momentum [N].
  [[nodiscard]] std::array<double, 3> mean_solid_force(std::size_t i) const { return mean_solid_force_.at(i); }
  /// Follows one sphere: mean_contact_force_of_tracked() is then kept.
  void track(std::optional<std::size_t> i) { tracked_ = i; }
  /// Mean force of the other spheres on the tracked one over the last advance() [N].
  [[nodiscard]] std::array<double, 3> mean_contact_force_of_tracked() const { return mean_tracked_force_; }

  /// Force of the other spheres on i at the last step [N].
  [[nodiscard]] std::array<double, 3> contact_force(std::size_t i) const { return components(contact_force_row_, i); }
  /// Force of the walls on i at the last step [N].
  [[nodiscard]] std::array<double, 3> wall_force(std::size_t i) const { return components(wall_force_row_, i); }
  /// Upward forces of the bottom (wall number 0) and of all other walls on the spheres, mean over the last advance()
  /// [N].
  struct VerticalWallForces {
    double bottom = 0.0, others = 0.0;
  };
  [[nodiscard]] VerticalWallForces mean_vertical_wall_forces() const;
  /// Spheres in contact with i at the last step [-].
  [[nodiscard]] int contacts(std::size_t i) const { return contacts_[i]; }
  /// New contacts of i with other spheres since it was added [-].
  [[nodiscard]] std::int64_t contact_events(std::size_t i) const { return contact_events_[i]; }
  /// True if i touches wall number `wall`.
  [[nodiscard]] bool touches_wall(std::size_t i, std::size_t wall) const;
  /// Largest overlap over the smaller radius at the last step [-].
  [[nodiscard]] double maximum_overlap() const { return maximum_overlap_; }

  /// All contacts of the last step.
  struct TouchingPair {
    std::uint32_t first, second;  ///< spheres; at a wall the sphere and the number of the wall
    bool at_wall;
    double normal_force;      ///< compressive positive [N]
    double tangential_force;  ///< magnitude [N]
  };
  [[nodiscard]] std::vector<TouchingPair> touching_pairs() const;
  /// From now on each finished collision between spheres is kept until take_collisions().
  void collect_collisions(bool on);
  /// Finished collisions since the last call, in the order of their ends.
  std::vector<Collision> take_collisions();

  /// Upper bound 2 Σ_j k_ij/m_i over all spheres i of the squared frequencies of the contact network at the last step
  /// (Gershgorin; springs of the normals) [1/s²]. Explicit steps are stable below Δt = 2/ω without damping.
  [[nodiscard]] double network_frequency_squared() const;

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] double time_step() const { return time_step_; }
  [[nodiscard]] int threads() const { return threads_; }
  /// How often the neighbour list was built, and its pairs: what tuning looks at.
  [[nodiscard]] std::int64_t list_builds() const { return list_builds_; }
  [[nodiscard]] std::size_t listed_pairs() const;

  /// Everything beyond the particles that the next step depends on, for checkpoints.
  struct Memory {
    std::vector<ContactRecord> contacts, wall_contacts;
    std::vector<std::int64_t> contact_events;
    VectorField mean_solid_force;
    VectorField list_position;          ///< positions when the neighbour list was built
    double skin = 0.0;                  ///< of that list [m]
    double travel = 0.0, margin = 0.0;  ///< how far spheres may have moved since they were last looked at, and may [m]
    std::int64_t list_step = 0, steps = 0;
    std::vector<double> integrator;  ///< rows of the integrator, sphere by sphere
  };
  [[nodiscard]] Memory memory() const;
  void restore(Particles state, const Memory& memory);

 private:
  /// Start: forces without motion. Final: the last of a call of advance(), after which much is asked for.
  enum class StepMode { start, middle, final };
  struct Share;
  struct PairList;
  struct OuterEffect;
  struct SecondBody;
  struct Records {
    std::vector<ContactRecord> spheres, walls;
  };

  void resize_particle_arrays();
  void number_order();
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
  void list_anew(const Records& records, std::optional<double> skin = {});
  void list_pairs(double skin);
  void rebuild();
  [[nodiscard]] Records contact_records() const;
  void remember(const Records& records);

  template <class Work>
  void for_shares(Work work);
  void one_step(StepMode mode);
  void add_lubrication();
  std::size_t find_touching(const PairList& list, std::uint32_t first, std::uint32_t last,
                            std::uint32_t* touching) const;
  template <bool AtWall, class Second, class Take>
  void compute(PairList& list, const std::uint32_t* touching, std::size_t count, Share& share, StepMode mode,
               Second second, Take take) const;
  template <class Take>
  void compute_pairs(PairList& list, const std::uint32_t* touching, std::size_t count, Share& share, StepMode mode,
                     Take take) const;
  void compute_walls(Share& share, StepMode mode);
  void compute_outer(Share& share, StepMode mode);
  void receive(const Share& share);
  void sweep(Share& share, StepMode mode);
  template <class Integrator>
  void move(Share& share, std::size_t first, std::size_t last, StepMode mode);
  template <class Integrator>
  void predict(std::size_t first, std::size_t last);
  template <class Integrator>
  void choose_integrator();
  [[noreturn]] void fail(const char* what, std::size_t slot) const;
  [[nodiscard]] std::uint32_t now() const { return static_cast<std::uint32_t>(steps_ + 1); }

  [[nodiscard]] std::array<double, 3> components(const std::vector<Row>& rows, std::size_t i) const {
    if (i >= slot_of_.size()) return {};  // nothing has moved yet
    const Row& row = rows[slot_of_[i]];
    return {row.x, row.y, row.z};
  }
  template <class Visit>
  void for_contacts(Visit visit) const;
  void finish_collision(Share& share, PairList& list, std::uint32_t p) const;
  void finish_collisions();

  Contact contact_;
  std::vector<Wall> walls_;
  std::array<double, 3> period_;
  double time_step_;
  int threads_;
  bool periodic_;
  ContactLawKernels law_;
  std::size_t rolling_;     ///< place of the rolling resistance among the kernels
  bool rolling_remembers_;  ///< whether it carries something from step to step
  // The instances of the templates that this scene's integrator needs.
  void (Engine::*move_)(Share&, std::size_t, std::size_t, StepMode) = nullptr;
  void (Engine::*predict_)(std::size_t, std::size_t) = nullptr;
  double spring_phase_ = 1.0;

  // By slot: spheres in the order of the cell grid.
  CellSearch search_;
  std::vector<std::uint32_t> order_, slot_of_;  ///< number of the sphere in a slot, and back
  std::vector<Row> place_;                      ///< centre; radius
  std::vector<Row> velocity_, spin_;            ///< w: 1/m, 1/I
  std::vector<Row> force_, torque_;             ///< of contacts with spheres and walls, zero between steps
  std::vector<Row> wall_force_row_;             ///< of walls at the last step
  std::vector<Row> contact_force_row_;          ///< of other spheres at the last step
  std::vector<Row> wall_lift_;                  ///< Σ over the steps of advance() of F_z: x of the bottom, y of others
  std::vector<Row> constant_;                   ///< acceleration by the external force
  std::vector<Row> origin_;                     ///< centres when the list was built
  std::vector<Row> integrator_;
  std::vector<std::int64_t> events_;
  std::vector<int> touched_;  ///< spheres in contact at the last step of advance()
  std::size_t integrator_rows_ = 0;
  std::vector<Row> row_scratch_;
  std::vector<std::uint32_t> number_scratch_;
  std::vector<std::int64_t> count_scratch_;
  std::array<Row, 27> image_shift_{};
  std::vector<std::unique_ptr<Share>> shares_;
  bool list_valid_ = false;
  double skin_ = 0.0;
  double travel_ = 0.0, margin_ = 0.0;  ///< bound of the largest displacement since it was last measured, and its limit
  std::int64_t list_step_ = 0, list_builds_ = 0, steps_ = 0, last_advance_ = 0;

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
};

}  // namespace slfb::dem
