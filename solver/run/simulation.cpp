#include "solver/run/simulation.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <numbers>
#include <stdexcept>
#include <string>

#include "solver/coupling/drag_relaxation.hpp"
#include "solver/coupling/force_balance.hpp"
#include "solver/coupling/late_reaction.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/checkpoint_files.hpp"
#include "solver/run/drop_protocol.hpp"
#include "solver/run/model.hpp"
#include "solver/run/provenance.hpp"
#include "solver/run/recorder.hpp"
#include "solver/run/run_title.hpp"
#include "solver/run/schedule.hpp"

namespace slfb {
namespace {

using namespace simulation;

Surroundings surroundings_of(const Stage& stage) {
  if (stage.kind != StageKind::settle) return Surroundings::liquid;
  return stage.dry ? Surroundings::nothing : Surroundings::resting_liquid;
}

/// A run: the schedule says what comes next, the model advances, the recorder reads it.
class Simulation {
 public:
  Simulation(const Scene& scene, const RunOptions& options);
  RunOutcome run();

 private:
  void resume();
  /// False if the run was stopped from outside.
  bool run_stage();
  void set_superficial_velocity();
  void advance();
  void take_out(std::int64_t removed);
  void advance_drop();
  void warn_of_deep_overlaps();
  void release_if_free();
  void save();
  [[nodiscard]] std::string late_reaction_hint() const;
  [[noreturn]] void fail(const std::exception& error);
  void exchange(io::StateGroup& state);

  const Scene& scene_;
  const RunOptions& options_;
  RunResult result_;
  Model model_;
  Schedule schedule_;
  DropProtocol drops_;
  Recorder recorder_;
  CheckpointFiles checkpoints_;
  ProgressReporter progress_;
  RunCost cost_;
  double warned_overlap_ = 0.5 * dem::Engine::deep_overlap;  ///< over the radius: twice this is told next
  double superficial_velocity_;                              ///< that the liquid has been given [m/s]
  std::chrono::steady_clock::time_point last_save_ = std::chrono::steady_clock::now();
};

Simulation::Simulation(const Scene& scene, const RunOptions& options)
    : scene_(scene),
      options_(options),
      result_(new_result(scene, options.threads)),
      model_(scene, options.threads),
      schedule_(scene.stages, scene.fluid.time_step),
      drops_(schedule_),
      recorder_(scene, model_, schedule_, options.directory, result_),
      checkpoints_(options.directory, result_.name),
      progress_(options.progress, options.progress_interval),
      cost_(options.threads),
      superficial_velocity_(scene.first_superficial_velocity()) {}

RunOutcome Simulation::run() {
  std::filesystem::create_directories(options_.directory);
  if (const auto reason = coupling::imbalance_of_forces(scene_); !reason.empty())
    spdlog::warn("{}: {}", run_title(scene_), reason);
  model_.fill();
  resume();
  if (options_.started) options_.started();
  try {
    for (; !schedule_.finished(); schedule_.next_stage()) {
      if (!run_stage()) return {RunStatus::interrupted, result_};
      recorder_.stage_ended();
    }
  } catch (const std::runtime_error& error) {
    fail(error);
  }
  recorder_.run_ended();
  cost_.write_to(result_);
  return {RunStatus::finished, result_};
}

bool Simulation::run_stage() {
  const bool drop = schedule_.stage().kind == StageKind::drop;
  if (schedule_.steps() == 0) set_superficial_velocity();
  if (drop && schedule_.steps() == 0) {
    drops_.begin();
    release_if_free();
  }
  while (!(drop ? drops_.finished() : schedule_.duration_is_over())) {
    advance();
    progress_.step_done(schedule_, drops_, result_, cost_.wall_seconds());
    const bool stopped = options_.stop != nullptr && options_.stop->load();
    const std::chrono::duration<double> since_save = std::chrono::steady_clock::now() - last_save_;
    if (stopped || since_save.count() > scene_.recording.checkpoint_interval) save();
    if (stopped) return false;
  }
  return true;
}

/// To that of the present stage, where it differs from that of the stage before.
void Simulation::set_superficial_velocity() {
  if (schedule_.stage().kind == StageKind::settle) return;
  const double velocity = scene_.superficial_velocity(schedule_.stage());
  if (velocity == superficial_velocity_) return;
  superficial_velocity_ = velocity;
  model_.set_superficial_velocity(velocity);
}

/// One liquid step, and what is recorded of it.
void Simulation::advance() {
  const StageKind kind = schedule_.stage().kind;
  recorder_.start_step();
  result_.particle_steps += model_.advance(surroundings_of(schedule_.stage()));
  result_.simulated_seconds += scene_.fluid.time_step;
  schedule_.count_step();
  warn_of_deep_overlaps();
  if (kind == StageKind::settle) return;
  recorder_.end_step();
  recorder_.record();
  if (kind == StageKind::drop) advance_drop();
  if (scene_.outlet.rule == OutletRule::remove) take_out(model_.remove_above_top());
}

/// Counts spheres that have left through the outlet.
void Simulation::take_out(std::int64_t removed) {
  if (removed > 0) recorder_.spheres_changed();
  result_.particles_removed += removed;
}

/// At the first deep overlap, and whenever the deepest has doubled since it was told.
void Simulation::warn_of_deep_overlaps() {
  const auto deepest = model_.take_deepest_contact();
  if (!deepest || deepest->share < 2.0 * warned_overlap_) return;
  warned_overlap_ = deepest->share;
  const double ratio = deepest->share / (0.5 * dem::Engine::deep_overlap);
  const std::string other = !deepest->at_wall      ? fmt::format("sphere {}", deepest->second)
                            : deepest->second == 0 ? "the distributor"
                                                   : "a side wall or the lid";
  spdlog::warn(
      "{}: {:.6g} s after the start of the run sphere {} overlaps {} by {:.2g} of the smaller radius, at "
      "({:.3g}, {:.3g}, {:.3g}) m; above {:g} spheres do not act as spheres any more; contacts some {:.2g} times as "
      "stiff, with contact.time_step as the check then asks, would stay well below that",
      run_title(scene_), result_.simulated_seconds, deepest->first, other, deepest->share, deepest->place.x,
      deepest->place.y, deepest->place.z, dem::Engine::deep_overlap, ratio * ratio);
}

void Simulation::advance_drop() {
  drops_.count_step();
  if (drops_.falling()) {
    const bool at_bottom = model_.dropped_sphere_at_bottom(),
               gone = scene_.outlet.rule == OutletRule::remove && model_.dropped_sphere_above_top(),
               over = at_bottom || gone || drops_.fall_is_over();
    recorder_.record_drop(drops_, at_bottom, over);
    if (!over) return;
    if (gone) {
      spdlog::warn("{}: the {} sphere has left through the outlet {:.3f} s after its release", run_title(scene_),
                   schedule_.stage().species, drops_.fall_seconds());
      take_out(1);
    }
    model_.take_out_dropped();
    drops_.taken_out();
    recorder_.spheres_changed();
  } else if (drops_.release_is_due()) {
    release_if_free();
  }
}

void Simulation::release_if_free() {
  const Stage& stage = schedule_.stage();
  const Species& species = *std::ranges::find(scene_.species, stage.species, &Species::name);
  if (model_.has_room(species, stage.release_height)) {
    model_.release(species, stage.release_height);
    drops_.released();
    recorder_.spheres_changed();
    recorder_.drop_started(species.name);
  } else if (drops_.waited_too_long()) {
    spdlog::warn("{}: no {} sphere is released at z = {} m: for {} s some sphere of the bed was in the way there",
                 run_title(scene_), species.name, stage.release_height, stage.duration);
    drops_.give_up();
  }
}

void Simulation::exchange(io::StateGroup& state) {
  state.part("schedule", [&](io::StateGroup& group) { schedule_.exchange(group); });
  // What follows is read by a liquid that already has the velocity of its stage.
  if (state.reading() && !schedule_.finished()) set_superficial_velocity();
  state.part("drops", [&](io::StateGroup& group) { drops_.exchange(group); });
  model_.exchange(state);
  recorder_.exchange(state);
}

void Simulation::resume() {
  if (checkpoints_.load(result_, [&](io::StateGroup& state) { exchange(state); })) {
    cost_.resume(result_);
    spdlog::info("resuming {} at {:.3f} s", result_.name, result_.simulated_seconds);
  }
  progress_.start(result_);
}

void Simulation::save() {
  cost_.write_to(result_);
  checkpoints_.save(result_, model_.engine().steps(), [&](io::StateGroup& state) { exchange(state); });
  last_save_ = std::chrono::steady_clock::now();
}

/// What follows where the spheres are too light for the liquid's answer, which is one step late.
std::string Simulation::late_reaction_hint() const {
  constexpr double packed_voidage = 0.4;
  const double there = coupling::density_ratio_of_bed(scene_),
               needed = coupling::least_density_ratio(scene_, packed_voidage);
  if (!model_.liquid().two_way() || there >= needed) return {};
  std::string settings, advice;
  if (scene_.fluid.time_scheme == TimeScheme::second_order) {
    settings += " with fluid.time_scheme = \"second-order\"";
    advice += "; \"euler\" bears spheres a quarter as dense";
  }
  if (scene_.coupling.void_fraction_interval > scene_.fluid.time_step) {
    settings += fmt::format(" with coupling.void_fraction_interval = {:g} s", scene_.coupling.void_fraction_interval);
    advice += "; void fractions in each liquid step bear spheres a third as dense";
  }
  if (advice.empty())
    advice = fmt::format("; a fluid.time_step of about a contact's duration, {:.2g} s, lets contacts hold the bed",
                         std::numbers::pi * contact_time_step_bound(scene_));
  return fmt::format(
      "; the liquid answers the spheres one step late, which a packed bed without contacts bears only with spheres of "
      "{:.3g} times the liquid's density{} (here {:.3g} times){}",
      needed, settings, there, advice);
}

void Simulation::fail(const std::exception& error) {
  std::string saved;
  try {
    const auto file = checkpoints_.save_failure([&](io::StateGroup& state) { exchange(state); });
    saved = "state saved in " + file.string();
  } catch (const std::exception& next) {  // on a full disk this fails for the same cause, which must not hide the first
    saved = fmt::format("its state could not be saved ({})", next.what());
  }
  // Only what spheres and liquid do in a step becomes better with a smaller one.
  const bool of_motion = dynamic_cast<const dem::EngineError*>(&error) != nullptr ||
                         dynamic_cast<const fluid::FluidError*>(&error) != nullptr;
  std::string hint;
  if (of_motion && model_.liquid().two_way())  // not when a law has failed: it would fail here too
    if (const double relaxation = coupling::packed_relaxation_time(scene_, find_drag_law(scene_.coupling.drag_law));
        scene_.fluid.time_step > relaxation)
      hint = fmt::format("; or a smaller fluid.time_step: drag stops a sphere of the packed bed within {:.2g} s",
                         relaxation);
  // Of a law too: it is then asked at voidages below 0.
  if (schedule_.stage().kind != StageKind::settle) hint += late_reaction_hint();
  throw std::runtime_error(fmt::format("{:.6g} s after the start of the run ({:.6g} s of fluidisation): {}{}; {}",
                                       result_.simulated_seconds, schedule_.fluidised_seconds(), error.what(), hint,
                                       saved));
}

}  // namespace

RunOutcome run_scene(const Scene& scene, const RunOptions& options) { return Simulation(scene, options).run(); }

void remove_checkpoints(const std::filesystem::path& directory) { CheckpointFiles::remove(directory); }

}  // namespace slfb
