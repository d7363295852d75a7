#include "solver/run/simulation.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <thread>

#include "correlations/materials.hpp"
#include "solver/coupling/drag_relaxation.hpp"
#include "solver/coupling/force_balance.hpp"
#include "solver/coupling/phase_coupling.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/granular_temperature.hpp"
#include "solver/dem/packing.hpp"
#include "solver/fluid/liquid_solver.hpp"
#include "solver/io/hdf5_file.hpp"
#include "solver/io/vtkhdf.hpp"
#include "solver/run/fluctuation_window.hpp"
#include "solver/scene/scene_file.hpp"

namespace slfb {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// CPU time of the calling thread, which leads the run; other runs of the process do not count [s].
double thread_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string machine_name() {
  std::ifstream cpu_info("/proc/cpuinfo");
  for (std::string line; std::getline(cpu_info, line);)
    if (line.starts_with("model name"))
      return fmt::format("{}, {} cores", line.substr(line.find(':') + 2), std::thread::hardware_concurrency());
  utsname system{};
  uname(&system);
  return system.machine;
}

void write_contacts(io::Hdf5File& h5, const std::string& name, const std::vector<dem::ContactRecord>& records) {
  std::vector<std::int64_t> numbers;
  std::vector<double> values;
  for (const dem::ContactRecord& c : records) {
    numbers.insert(numbers.end(), {c.first, c.second, c.first_step});
    values.insert(values.end(), {c.spring.x, c.spring.y, c.spring.z, c.rolling_memory.x, c.rolling_memory.y,
                                 c.rolling_memory.z, c.impact_speed});
  }
  h5.write(name + "/numbers", numbers);
  h5.write(name + "/values", values);
}

std::vector<dem::ContactRecord> read_contacts(const io::Hdf5File& h5, const std::string& name) {
  const auto numbers = h5.read_integers(name + "/numbers");
  const auto values = h5.read_doubles(name + "/values");
  std::vector<dem::ContactRecord> records;
  for (std::size_t c = 0; c < numbers.size() / 3; ++c) {
    const auto number = [&](std::size_t k) { return static_cast<std::uint32_t>(numbers[3 * c + k]); };
    const double* v = &values[7 * c];
    records.push_back({number(0), number(1), {v[0], v[1], v[2]}, {v[3], v[4], v[5]}, number(2), v[6]});
  }
  return records;
}

void write_fields(io::Hdf5File& h5, const std::string& group, const NamedFields& fields) {
  for (const auto& [name, values] : fields) h5.write(fmt::format("{}/{}", group, name), values);
}

/// What write_fields wrote: the data sets of a group, and those of its groups as "part/name".
NamedFields read_fields(const io::Hdf5File& h5, const std::string& group) {
  NamedFields fields;
  for (const std::string& name : h5.children(group)) {
    const std::string path = fmt::format("{}/{}", group, name);
    if (name == "interval" || name == "forces_beyond_drag")
      add_part(fields, name, read_fields(h5, path));
    else
      fields[name] = h5.read_doubles(path);
  }
  return fields;
}

/// Where a run stands: the stage, the steps done in it, and for drops the sphere and its phase.
struct Position {
  std::int64_t stage = 0, steps = 0, repetition = 0, falling = 0, phase_steps = 0;
};

class Simulation {
 public:
  Simulation(const Scene& scene, const RunOptions& options);
  RunOutcome run();

 private:
  void start();
  bool stage_finished() const;
  void begin_stage();
  void end_stage();
  void advance();
  void advance_drop(const Stage& stage);
  void release(const Stage& stage);
  void release_when_free(const Stage& stage);
  [[nodiscard]] bool in_the_way(const Stage& stage, double radius) const;
  void take_out();
  void remove_at_outlet();
  [[nodiscard]] double sphere_momentum() const;
  void add_to_balance(double momentum_before);
  void sample_balance();
  void sample_bed();
  void sample_contact_forces();
  void sample_drop();
  void record_plane();
  void take_snapshot(const std::string& moment);
  void take_snapshots_of_drop(bool ended);
  void write_snapshot();
  void save(const std::filesystem::path& file) const;
  bool resume(const std::filesystem::path& file);
  [[nodiscard]] std::filesystem::path records_file(std::int64_t dem_steps) const;
  void report_progress();
  [[nodiscard]] double planned_seconds() const;
  [[nodiscard]] coupling::PhaseCoupling& coupling() {
    return scene_.stages[static_cast<std::size_t>(position_.stage)].kind == StageKind::settle ? *still_ : *coupled_;
  }
  [[nodiscard]] std::int64_t steps_in(double duration) const { return std::llround(duration / scene_.fluid.time_step); }
  [[nodiscard]] std::int64_t relaxation_steps(const Stage& drop) const {
    return std::max<std::int64_t>(1, steps_in(drop.relaxation));
  }
  [[nodiscard]] const Species& species_of(const Stage& drop) const {
    return *std::ranges::find(scene_.species, drop.species, &Species::name);
  }
  [[nodiscard]] double fluidised_seconds() const {
    return static_cast<double>(fluidised_steps_) * scene_.fluid.time_step;
  }

  const Scene& scene_;
  const RunOptions& options_;
  dem::Engine engine_;
  std::unique_ptr<fluid::LiquidSolver> liquid_;
  std::unique_ptr<coupling::PhaseCoupling> still_, coupled_;
  std::optional<FluctuationWindow> window_;
  RunResult result_;
  Position position_;
  std::int64_t fluidised_steps_ = 0, substeps_ = 1;
  std::int64_t foreign_ = -1;       ///< index of the dropped sphere, -1 if none
  coupling::ForceBalance balance_;  ///< sums since the last sample of the bed
  double balance_steps_ = 0.0, largest_residual_ = 0.0, liquid_momentum_ = 0.0;
  /// Liquid appears or vanishes where a sphere is put in or taken out: that step is not balanced.
  bool balanced_ = false;
  std::array<double, 3> tracked_force_{};  ///< sum of the contact force on the dropped sphere since its last sample
  double tracked_steps_ = 0.0;
  bool warned_of_network_ = false;
  Clock::time_point started_ = Clock::now(), last_checkpoint_ = Clock::now(), last_report_ = Clock::now();
  double wall_before_ = 0.0, cpu_before_ = 0.0, cpu_started_ = thread_cpu_seconds();
  std::int64_t steps_at_start_ = 0;
};

std::array<double, 3> period_of(const Scene& scene) {
  if (scene.geometry.shape != Shape::box || scene.fluid.wall != LateralBoundary::periodic) return {0.0, 0.0, 0.0};
  return {scene.geometry.width[0], scene.geometry.width[1], 0.0};
}

Simulation::Simulation(const Scene& scene, const RunOptions& options)
    : scene_(scene),
      options_(options),
      engine_(scene.contact, dem::walls_of(scene), period_of(scene), options.threads),
      substeps_(std::llround(scene.fluid.time_step / scene.contact.time_step)) {
  if (scene.coupling.lubrication_range > 0.0)
    engine_.lubricate({scene.liquid.viscosity, scene.coupling.lubrication_roughness, scene.coupling.lubrication_range});
  if (scene.fluid.tier != FluidTier::quiescent)
    liquid_ = std::make_unique<fluid::LiquidSolver>(scene, false, options.threads);
  if (liquid_) window_.emplace(liquid_->grid());
  still_ = std::make_unique<coupling::PhaseCoupling>(scene, nullptr);
  coupled_ = std::make_unique<coupling::PhaseCoupling>(scene, liquid_.get(), scene.liquid.superficial_velocity);
}

void Simulation::start() {
  for (const dem::PlacedSphere& sphere : dem::loose_packing(scene_)) {
    const Species& species = scene_.species[static_cast<std::size_t>(sphere.species)];
    engine_.add_particle(sphere.centre, 0.5 * species.diameter, species.density, sphere.species);
  }
  result_.name = scene_hash(scene_);
  result_.scene_text = canonical_toml(scene_);
  result_.suite_version = SLFB_VERSION;
  result_.threads = options_.threads;
  result_.steps_per_contact = std::numbers::pi * contact_time_step_bound(scene_) / scene_.contact.time_step;
  result_.machine = machine_name();
}

double Simulation::planned_seconds() const {
  // A drop ends when the sphere arrives: estimate the rest from those that have.
  double sum = 0.0;
  for (const Stage& stage : scene_.stages) {
    if (stage.kind != StageKind::drop) {
      sum += stage.duration;
      continue;
    }
    double fall = std::min(stage.duration, 3.0);
    if (!result_.drops.empty() && result_.drops.front().bottom_time > 0.0) fall = result_.drops.front().bottom_time;
    sum += stage.repetitions * (fall + stage.relaxation);
  }
  return sum;
}

bool Simulation::stage_finished() const {
  const Stage& stage = scene_.stages[static_cast<std::size_t>(position_.stage)];
  if (stage.kind == StageKind::drop) return position_.repetition >= stage.repetitions;
  return position_.steps >= steps_in(stage.duration);
}

void Simulation::begin_stage() {
  const Stage& stage = scene_.stages[static_cast<std::size_t>(position_.stage)];
  if (stage.kind == StageKind::drop && position_.steps == 0) {
    position_.phase_steps = relaxation_steps(stage);  // as if after a drop
    release_when_free(stage);
  }
}

void Simulation::end_stage() {
  const Stage& stage = scene_.stages[static_cast<std::size_t>(position_.stage)];
  const auto& particles = engine_.particles;
  if (stage.kind == StageKind::settle && particles.size() > 0) {
    double moment = 0.0, volume = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      moment += particles.volume(i) * particles.position.z[i];
      volume += particles.volume(i);
    }
    result_.packed_height = 2.0 * moment / volume;
    result_.packed_voidage = 1.0 - volume / (scene_.geometry.cross_section() * result_.packed_height);
  }
  if (stage.kind == StageKind::fluidise) {
    record_plane();
    if (window_) window_->reduce(result_.fluctuation);
  }
}

/// Whether a sphere of the bed lies where a sphere of this radius is released.
bool Simulation::in_the_way(const Stage& stage, double radius) const {
  const auto& position = engine_.particles.position;
  for (std::size_t i = 0; i < engine_.particles.size(); ++i)
    if (std::hypot(position.x[i], position.y[i], position.z[i] - stage.release_height) <
        radius + engine_.particles.radius[i])
      return true;
  return false;
}

/// Releases the sphere, or waits: in a bed that reaches up to there spheres come and go. They get as long as a drop;
/// after that the bed counts as one that fills its column, and the stage ends without further drops.
void Simulation::release_when_free(const Stage& stage) {
  const Species& species = species_of(stage);
  if (!in_the_way(stage, 0.5 * species.diameter)) return release(stage);
  if (position_.phase_steps - relaxation_steps(stage) < steps_in(stage.duration)) return;
  spdlog::warn("{}: no {} sphere is released at z = {} m: for {} s some sphere of the bed was in the way there",
               scene_.title, species.name, stage.release_height, stage.duration);
  position_.repetition = stage.repetitions;
}

void Simulation::release(const Stage& stage) {
  const Species& species = species_of(stage);
  const double radius = 0.5 * species.diameter;
  foreign_ = static_cast<std::int64_t>(engine_.add_particle({0.0, 0.0, stage.release_height}, radius, species.density,
                                                            static_cast<int>(&species - scene_.species.data())));
  engine_.track(static_cast<std::size_t>(foreign_));
  coupled_->sphere_added();
  balanced_ = false;
  DropSeries drop;
  drop.release_time = fluidised_seconds();
  drop.species = species.name;
  result_.drops.push_back(std::move(drop));
  position_.falling = 1;
  position_.phase_steps = 0;
  if (result_.drops.size() == 1) take_snapshot("release");
}

void Simulation::take_out() {
  engine_.remove_particle(static_cast<std::size_t>(foreign_));
  coupled_->sphere_removed(static_cast<std::size_t>(foreign_));
  balanced_ = false;
  foreign_ = -1;
  position_.falling = 0;
  position_.phase_steps = 0;
}

void Simulation::remove_at_outlet() {
  if (scene_.outlet.rule != OutletRule::remove) return;
  for (std::size_t i = engine_.particles.size(); i-- > 0;) {
    if (engine_.particles.position.z[i] < scene_.geometry.height) continue;
    if (static_cast<std::int64_t>(i) == foreign_) continue;
    engine_.remove_particle(i);
    if (foreign_ > static_cast<std::int64_t>(i)) --foreign_;
    coupled_->sphere_removed(i);
    balanced_ = false;
    ++result_.particles_removed;
  }
}

void Simulation::advance() {
  coupling::PhaseCoupling& exchange = coupling();
  const double momentum_before = sphere_momentum();
  exchange.advance(engine_, scene_.fluid.time_step);
  engine_.advance(substeps_);
  result_.particle_steps += substeps_ * static_cast<std::int64_t>(engine_.particles.size());
  result_.simulated_seconds += scene_.fluid.time_step;
  ++position_.steps;

  const Stage& stage = scene_.stages[static_cast<std::size_t>(position_.stage)];
  if (stage.kind == StageKind::settle) return;
  ++fluidised_steps_;
  add_to_balance(momentum_before);
  remove_at_outlet();
  if (fluidised_steps_ % std::max<std::int64_t>(1, steps_in(scene_.recording.bed_interval)) == 0) {
    sample_bed();
    if (window_ && stage.kind == StageKind::fluidise && 2 * position_.steps > steps_in(stage.duration))
      window_->sample(fluidised_seconds(), coupled_->cell_velocity(), result_.fluctuation);
  }
  if (scene_.recording.snapshot_interval > 0.0 && fluidised_steps_ % steps_in(scene_.recording.snapshot_interval) == 0)
    write_snapshot();
  if (stage.kind == StageKind::drop) advance_drop(stage);
}

void Simulation::advance_drop(const Stage& stage) {
  ++position_.phase_steps;
  if (position_.falling == 0) {
    if (position_.phase_steps < relaxation_steps(stage)) return;
    if (position_.phase_steps == relaxation_steps(stage)) ++position_.repetition;
    if (position_.repetition < stage.repetitions) release_when_free(stage);
    return;
  }
  if (position_.phase_steps % std::max<std::int64_t>(1, steps_in(scene_.recording.drop_interval)) == 0) sample_drop();
  const bool arrived = engine_.touches_wall(static_cast<std::size_t>(foreign_), 0);
  if (arrived) result_.drops.back().bottom_time = static_cast<double>(position_.phase_steps) * scene_.fluid.time_step;
  const bool ended = arrived || position_.phase_steps >= steps_in(stage.duration);
  take_snapshots_of_drop(ended);
  if (ended) take_out();
}

double Simulation::sphere_momentum() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < engine_.particles.size(); ++i)
    sum += engine_.particles.mass[i] * engine_.particles.velocity.z[i];
  return sum;
}

void Simulation::add_to_balance(double momentum_before) {
  if (foreign_ >= 0) {
    const auto mean = engine_.mean_contact_force_of_tracked();
    for (std::size_t a = 0; a < 3; ++a) tracked_force_[a] += mean[a];
    ++tracked_steps_;
  }
  if (!liquid_) return;
  const double momentum = liquid_->vertical_momentum();
  const double before = std::exchange(liquid_momentum_, momentum);
  if (!std::exchange(balanced_, true)) return;
  using Balance = coupling::ForceBalance;
  Balance now;
  const auto contacts = engine_.mean_vertical_wall_forces();
  const auto& liquid = liquid_->vertical_forces();
  for (std::size_t i = 0; i < engine_.particles.size(); ++i)
    now.force[Balance::buoyant_weight] -=
        gravitational_acceleration * (engine_.particles.mass[i] - scene_.liquid.density * engine_.particles.volume(i));
  now.force[Balance::pressure] = liquid.pressure;
  now.force[Balance::bottom] = contacts.bottom;
  now.force[Balance::walls] = contacts.others;
  now.force[Balance::shear] = liquid.stress;
  now.force[Balance::flow] = liquid.inflow - liquid.outflow;
  now.force[Balance::sphere_inertia] = -(sphere_momentum() - momentum_before) / scene_.fluid.time_step;
  now.force[Balance::liquid_inertia] = -(momentum - before) / scene_.fluid.time_step;
  for (std::size_t t = 0; t < Balance::terms; ++t) balance_.force[t] += now.force[t];
  ++balance_steps_;
  largest_residual_ = std::max(largest_residual_, std::abs(now.residual() / now.force[Balance::buoyant_weight]));
}

void Simulation::sample_balance() {
  using Balance = coupling::ForceBalance;
  BedSeries& bed = result_.bed;
  const std::array<std::vector<double>*, Balance::terms> columns{
      &bed.pressure_force, &bed.buoyant_weight, &bed.bottom_force,   &bed.wall_force,
      &bed.shear_force,    &bed.flow_force,     &bed.sphere_inertia, &bed.liquid_inertia};
  for (std::size_t t = 0; t < Balance::terms; ++t)
    columns[t]->push_back(balance_.force[t] / std::max(1.0, balance_steps_));
  bed.balance_residual.push_back(largest_residual_);
  balance_ = {};
  balance_steps_ = largest_residual_ = 0.0;
}

void Simulation::sample_bed() {
  const auto& particles = engine_.particles;
  BedSeries& bed = result_.bed;
  std::vector<double> heights;
  double moment = 0.0, volume = 0.0, contacts = 0.0, events = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (static_cast<std::int64_t>(i) == foreign_) continue;
    heights.push_back(particles.position.z[i]);
    moment += particles.volume(i) * particles.position.z[i];
    volume += particles.volume(i);
    contacts += engine_.contacts(i);
    events += static_cast<double>(engine_.contact_events(i));
  }
  if (heights.empty()) return;
  const auto n = static_cast<double>(heights.size());
  const auto top = heights.begin() + static_cast<std::ptrdiff_t>(0.99 * (n - 1.0));
  std::nth_element(heights.begin(), top, heights.end());
  bed.time.push_back(fluidised_seconds());
  bed.pressure_drop.push_back(liquid_ ? liquid_->inlet_pressure() : 0.0);
  bed.centre_of_mass_height.push_back(moment / volume);
  bed.bed_top.push_back(*top);
  std::optional<std::size_t> excluded;
  if (foreign_ >= 0) excluded = static_cast<std::size_t>(foreign_);
  const double box = 8.0 * *std::max_element(particles.radius.begin(), particles.radius.end());
  bed.fluctuating_energy.push_back(dem::fluctuating_energy(particles, excluded));
  bed.local_fluctuating_energy.push_back(dem::local_fluctuating_energy(particles, {box, box, box}, excluded));
  bed.contacts_per_particle.push_back(contacts / n);
  bed.cumulative_contacts.push_back(events / n);
  sample_contact_forces();
  sample_balance();
  bed.maximum_overlap.push_back(engine_.maximum_overlap());
  bed.foreign_present.push_back(foreign_ >= 0 ? 1.0 : 0.0);
}

void Simulation::sample_drop() {
  const auto i = static_cast<std::size_t>(foreign_);
  const auto& particles = engine_.particles;
  DropSeries& drop = result_.drops.back();
  drop.time.push_back(static_cast<double>(position_.phase_steps) * scene_.fluid.time_step);
  drop.x.push_back(particles.position.x[i]);
  drop.y.push_back(particles.position.y[i]);
  drop.z.push_back(particles.position.z[i]);
  drop.velocity_x.push_back(particles.velocity.x[i]);
  drop.velocity_y.push_back(particles.velocity.y[i]);
  drop.velocity_z.push_back(particles.velocity.z[i]);
  const auto spin = particles.angular_velocity.at(i);
  drop.angular_speed.push_back(std::hypot(spin[0], spin[1], spin[2]));
  drop.voidage.push_back(coupled_->voidage(i));
  drop.liquid_velocity_z.push_back(coupled_->liquid_velocity(i, 2));
  drop.reynolds.push_back(coupled_->reynolds(i));
  const auto force = engine_.contact_force(i);
  drop.contact_force.push_back(std::hypot(force[0], force[1], force[2]));
  drop.contact_force_mean_x.push_back(tracked_force_[0] / tracked_steps_);
  drop.contact_force_mean_y.push_back(tracked_force_[1] / tracked_steps_);
  drop.contact_force_mean_z.push_back(tracked_force_[2] / tracked_steps_);
  tracked_force_ = {};
  tracked_steps_ = 0.0;
  drop.drag_force_z.push_back(coupled_->drag_force(i, 2));
  drop.pressure_force_z.push_back(coupled_->pressure_force(i, 2));
  drop.contacts.push_back(engine_.contacts(i));
  drop.cumulative_contacts.push_back(static_cast<double>(engine_.contact_events(i)));
}

/// Mean normal force of the contacts by who touches, and whether the step can follow the network they make.
void Simulation::sample_contact_forces() {
  std::array<double, 3> sum{}, count{};
  enum Kind : std::size_t { bed, foreign, wall };
  for (const auto& pair : engine_.touching_pairs()) {
    const bool of_foreign =
        std::int64_t{pair.first} == foreign_ || (!pair.at_wall && std::int64_t{pair.second} == foreign_);
    const Kind kind = pair.at_wall ? wall : of_foreign ? foreign : bed;
    sum[kind] += pair.normal_force;
    count[kind] += 1.0;
  }
  const auto mean = [&](Kind kind) { return count[kind] > 0.0 ? sum[kind] / count[kind] : 0.0; };
  result_.bed.contact_force_bed.push_back(mean(bed));
  result_.bed.contact_force_foreign.push_back(mean(foreign));
  result_.bed.contact_force_wall.push_back(mean(wall));
  const double network_step = engine_.time_step() * std::sqrt(engine_.network_frequency_squared());
  result_.bed.network_step.push_back(network_step);
  if (network_step > 2.0 && !warned_of_network_) {
    warned_of_network_ = true;
    spdlog::warn(
        "{}: at {:.3f} s the contacts of one sphere make up to {:.2f} of contact.time_step = {:g} s; steps are surely "
        "stable only below 2 (step times frequency, 2 sum k/m per sphere), so that here {:.3g} s would be needed",
        scene_.title, fluidised_seconds(), network_step, engine_.time_step(), 2.0 / network_step * engine_.time_step());
  }
}

/// Void fraction and velocity on the cells of the plane y = 0; between two rows of cells their mean.
void Simulation::record_plane() {
  if (!liquid_) return;
  const fluid::ColumnGrid& grid = liquid_->grid();
  const auto voidage = coupled_->void_fraction();
  const auto velocity = coupled_->cell_velocity();
  if (voidage.empty()) return;
  PlaneField plane;
  plane.time = fluidised_seconds();
  const int rows = grid.squares(1), upper = rows / 2, lower = rows % 2 == 0 ? upper - 1 : upper;
  for (int ix = 0; ix < grid.squares(0); ++ix) plane.x.push_back(grid.lower(0) + (ix + 0.5) * grid.spacing(0));
  for (int k = 0; k < grid.layers(); ++k) {
    plane.z.push_back((k + 0.5) * grid.cell_height());
    for (int ix = 0; ix < grid.squares(0); ++ix) {
      const auto mean = [&](const std::vector<double>& field) {
        const auto at = [&](int iy) {
          return field[static_cast<std::size_t>(grid.cell_of_square(ix, iy) * grid.layers() + k)];
        };
        return 0.5 * (at(lower) + at(upper));
      };
      plane.voidage.push_back(mean(voidage));
      plane.velocity_x.push_back(mean(velocity[0]));
      plane.velocity_z.push_back(mean(velocity[2]));
    }
  }
  result_.plane = std::move(plane);
}

void Simulation::take_snapshot(const std::string& moment) {
  constexpr double resolution = 1.0 / 65536.0;  // [m]; what is below would only fill the file
  const auto& particles = engine_.particles;
  Snapshot snapshot{
      moment,          fluidised_seconds(), foreign_, particles.position.x, particles.position.y, particles.position.z,
      particles.radius};
  for (auto* coordinate : {&snapshot.x, &snapshot.y, &snapshot.z})
    for (double& value : *coordinate) value = resolution * std::round(value / resolution);
  result_.snapshots.push_back(std::move(snapshot));
}

/// The first dropped sphere when it enters the bed, halfway down, and at the end of its way.
void Simulation::take_snapshots_of_drop(bool ended) {
  if (result_.drops.size() != 1 || result_.bed.bed_top.empty()) return;
  const double z = engine_.particles.position.z[static_cast<std::size_t>(foreign_)];
  const double top = result_.bed.bed_top.back();
  if (result_.snapshots.size() == 1 && z < top) take_snapshot("enters");
  if (result_.snapshots.size() == 2 && z < 0.5 * top) take_snapshot("halfway");
  if (ended) take_snapshot("ends");
}

void Simulation::write_snapshot() {
  const auto folder = options_.directory / "snapshots";
  std::filesystem::create_directories(folder);
  const double time = fluidised_seconds();
  io::write_particles_vtkhdf(folder / fmt::format("particles_{:08.3f}s.vtkhdf", time), engine_.particles, time);
  if (liquid_)
    io::write_liquid_vtkhdf(folder / fmt::format("liquid_{:08.3f}s.vtkhdf", time), liquid_->grid(),
                            coupled_->void_fraction(), coupled_->cell_velocity(), liquid_->pressure(), time);
}

void Simulation::save(const std::filesystem::path& file) const {
  io::write_atomically(file, [&](io::Hdf5File& h5) {
    const auto& particles = engine_.particles;
    const auto write_vector = [&](const std::string& name, const dem::VectorField& field) {
      h5.write(name + "/x", field.x);
      h5.write(name + "/y", field.y);
      h5.write(name + "/z", field.z);
    };
    write_vector("particles/position", particles.position);
    write_vector("particles/velocity", particles.velocity);
    write_vector("particles/angular_velocity", particles.angular_velocity);
    h5.write("particles/radius", particles.radius);
    h5.write("particles/mass", particles.mass);
    h5.write("particles/species", std::vector<std::int64_t>(particles.species.begin(), particles.species.end()));
    const dem::Engine::Memory memory = engine_.memory();
    write_contacts(h5, "contacts/spheres", memory.contacts);
    write_contacts(h5, "contacts/walls", memory.wall_contacts);
    h5.write("contacts/events", memory.contact_events);
    write_vector("contacts/mean_solid_force", memory.mean_solid_force);
    write_vector("neighbour_list/position", memory.list_position);
    h5.write("neighbour_list/lengths", std::vector<double>{memory.skin, memory.travel, memory.margin}, "m");
    h5.write("integrator", memory.integrator);
    if (liquid_) write_fields(h5, "liquid", liquid_->state());
    write_fields(h5, "still", still_->state());
    write_fields(h5, "coupled", coupled_->state());
    h5.write("clock", std::vector<std::int64_t>{memory.list_step, memory.steps, position_.stage, position_.steps,
                                                position_.repetition, position_.falling, position_.phase_steps,
                                                fluidised_steps_, foreign_});
    std::vector<double> sums(balance_.force.begin(), balance_.force.end());
    sums.insert(sums.end(), {balance_steps_, largest_residual_, liquid_momentum_, balanced_ ? 1.0 : 0.0,
                             tracked_force_[0], tracked_force_[1], tracked_force_[2], tracked_steps_});
    h5.write("particles/added_mass", particles.added_mass);
    h5.write("sums_since_last_sample", sums);
    h5.write_attribute("/", "scene_hash", scene_hash(scene_));
  });
}

std::filesystem::path Simulation::records_file(std::int64_t dem_steps) const {
  return options_.directory / fmt::format("records_{}.h5", dem_steps);
}

bool Simulation::resume(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return false;
  auto h5 = io::Hdf5File::open(file);
  if (h5.read_string_attribute("/", "scene_hash") != scene_hash(scene_)) return false;
  const auto read_vector = [&](const std::string& name) {
    return dem::VectorField{h5.read_doubles(name + "/x"), h5.read_doubles(name + "/y"), h5.read_doubles(name + "/z")};
  };
  dem::Particles particles;
  particles.position = read_vector("particles/position");
  particles.velocity = read_vector("particles/velocity");
  particles.angular_velocity = read_vector("particles/angular_velocity");
  particles.radius = h5.read_doubles("particles/radius");
  particles.mass = h5.read_doubles("particles/mass");
  particles.added_mass = h5.read_doubles("particles/added_mass");
  for (const std::int64_t s : h5.read_integers("particles/species")) particles.species.push_back(static_cast<int>(s));
  const auto clock = h5.read_integers("clock");
  dem::Engine::Memory memory;
  memory.contacts = read_contacts(h5, "contacts/spheres");
  memory.wall_contacts = read_contacts(h5, "contacts/walls");
  memory.contact_events = h5.read_integers("contacts/events");
  memory.mean_solid_force = read_vector("contacts/mean_solid_force");
  memory.list_position = read_vector("neighbour_list/position");
  const auto lengths = h5.read_doubles("neighbour_list/lengths");
  memory.skin = lengths.at(0);
  memory.travel = lengths.at(1);
  memory.margin = lengths.at(2);
  memory.integrator = h5.read_doubles("integrator");
  memory.list_step = clock.at(0);
  memory.steps = clock.at(1);
  engine_.restore(std::move(particles), memory);
  position_ = {clock.at(2), clock.at(3), clock.at(4), clock.at(5), clock.at(6)};
  fluidised_steps_ = clock.at(7);
  foreign_ = clock.at(8);
  if (foreign_ >= 0) engine_.track(static_cast<std::size_t>(foreign_));
  if (liquid_) liquid_->restore(read_fields(h5, "liquid"));
  still_->restore(read_fields(h5, "still"), engine_.particles);
  coupled_->restore(read_fields(h5, "coupled"), engine_.particles);
  const auto sums = h5.read_doubles("sums_since_last_sample");
  std::copy_n(sums.begin(), balance_.force.size(), balance_.force.begin());
  const auto sum = [&](std::size_t k) { return sums.at(balance_.force.size() + k); };
  balance_steps_ = sum(0);
  largest_residual_ = sum(1);
  liquid_momentum_ = sum(2);
  balanced_ = sum(3) != 0.0;
  tracked_force_ = {sum(4), sum(5), sum(6)};
  tracked_steps_ = sum(7);
  result_ = load_result(records_file(memory.steps));
  wall_before_ = result_.wall_seconds;
  cpu_before_ = result_.cpu_seconds;
  return true;
}

/// Removes the records of all checkpoints but the one whose records are `kept`.
void remove_records(const std::filesystem::path& directory, const std::filesystem::path& kept) {
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.path().filename().string().starts_with("records_") && entry.path() != kept)
      std::filesystem::remove(entry.path());
}

void Simulation::report_progress() {
  if (!options_.progress || seconds_since(last_report_) < options_.progress_interval) return;
  last_report_ = Clock::now();
  static constexpr std::array names{"settle", "fluidise", "drop"};
  const Stage& stage = scene_.stages[static_cast<std::size_t>(position_.stage)];
  Progress progress;
  progress.stage = names[static_cast<std::size_t>(stage.kind)];
  if (stage.kind == StageKind::drop)
    progress.stage += fmt::format(" {}/{}", position_.repetition + 1, stage.repetitions);
  progress.simulated_seconds = result_.simulated_seconds;
  progress.planned_seconds = std::max(planned_seconds(), result_.simulated_seconds);
  progress.wall_seconds = wall_before_ + seconds_since(started_);
  progress.particle_steps_per_second =
      static_cast<double>(result_.particle_steps - steps_at_start_) / std::max(1e-9, seconds_since(started_));
  options_.progress(progress);
}

RunOutcome Simulation::run() {
  std::filesystem::create_directories(options_.directory);
  const auto checkpoint = options_.directory / "checkpoint.h5";
  start();
  const auto update_cost = [&] {
    result_.wall_seconds = wall_before_ + seconds_since(started_);
    result_.cpu_seconds = cpu_before_ + (thread_cpu_seconds() - cpu_started_) * options_.threads;
    result_.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  };
  const auto save_all = [&] {
    // The records carry the step in their name and go first: whenever a crash comes, the checkpoint finds its own.
    update_cost();
    save_result(result_, records_file(engine_.steps()));
    save(checkpoint);
    remove_records(options_.directory, records_file(engine_.steps()));
    last_checkpoint_ = Clock::now();
  };
  try {
    if (resume(checkpoint)) spdlog::info("resuming {} at {:.3f} s", result_.name, result_.simulated_seconds);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("the checkpoint of an earlier start is damaged: {}; remove {} to start anew",
                                         error.what(), options_.directory.string()));
  }
  steps_at_start_ = result_.particle_steps;
  try {
    for (; position_.stage < static_cast<std::int64_t>(scene_.stages.size());
         ++position_.stage, position_.steps = 0, position_.repetition = 0, position_.phase_steps = 0) {
      begin_stage();
      while (!stage_finished()) {
        advance();
        report_progress();
        const bool stopped = options_.stop != nullptr && options_.stop->load();
        if (stopped || seconds_since(last_checkpoint_) > scene_.recording.checkpoint_interval) save_all();
        if (stopped) return {RunStatus::interrupted, result_};
      }
      end_stage();
    }
  } catch (const std::runtime_error& error) {
    const auto file = options_.directory / "failure.h5";
    save(file);
    const double relaxation = coupling::packed_relaxation_time(scene_);
    const std::string hint =
        liquid_ && scene_.fluid.time_step > relaxation
            ? fmt::format("; or a smaller fluid.time_step: drag stops a sphere of the packed bed within {:.2g} s",
                          relaxation)
            : "";
    throw std::runtime_error(
        fmt::format("{:.6g} s after the start of the run ({:.6g} s of fluidisation): {}{}; state saved in {}",
                    result_.simulated_seconds, fluidised_seconds(), error.what(), hint, file.string()));
  }
  update_cost();
  return {RunStatus::finished, result_};
}

}  // namespace

RunOutcome run_scene(const Scene& scene, const RunOptions& options) { return Simulation(scene, options).run(); }

void remove_checkpoints(const std::filesystem::path& directory) {
  for (const char* file : {"checkpoint.h5", "failure.h5"}) std::filesystem::remove(directory / file);
  remove_records(directory, {});
}

}  // namespace slfb
