#include "solver/run/recorder.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <string>

#include "solver/io/vtkhdf.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/plugs.hpp"
#include "solver/run/run_title.hpp"
#include "solver/support/files.hpp"

namespace slfb::simulation {

Recorder::Recorder(const Scene& scene, Model& model, const Schedule& schedule, const std::filesystem::path& directory,
                   RunResult& result)
    : scene_(scene),
      model_(model),
      schedule_(schedule),
      directory_(directory),
      bed_(scene, result),
      drop_(result),
      liquid_(scene, model, result),
      balance_(scene),
      law_range_(find_drag_law(scene.coupling.drag_law).info, scene.species),
      result_(result) {}

void Recorder::end_step() {
  drop_.end_step(model_);
  balance_.end_step(model_);
}

void Recorder::record() {
  const double time = schedule_.fluidised_seconds();
  const Recording& recording = scene_.recording;
  if (schedule_.due(recording.bed_interval)) {
    if (bed_.sample(model_, time, scene_.superficial_velocity(schedule_.stage()))) balance_.take(result_.bed);
    law_range_.sample(model_);
    if (schedule_.in_last_fluidisation() && schedule_.in_second_half()) liquid_.sample_fluctuation(model_, time);
  }
  if (recording.snapshot_interval > 0.0 && schedule_.due(recording.snapshot_interval)) write_snapshot();
}

void Recorder::drop_started(const std::string& species) {
  drop_.start_drop(model_, species, schedule_.fluidised_seconds());
}

void Recorder::record_drop(const DropProtocol& drops, bool at_bottom, bool over) {
  if (drops.fall_steps() % schedule_.interval_steps(scene_.recording.drop_interval) == 0)
    drop_.sample(model_, drops.fall_seconds());
  if (at_bottom) drop_.arrived(drops.fall_seconds());
  drop_.take_snapshots(model_, over, schedule_.fluidised_seconds());
}

void Recorder::stage_ended() {
  if (schedule_.stage().kind == StageKind::settle) bed_.measure_packed_bed(model_, !schedule_.stage().dry);
  if (schedule_.in_last_fluidisation()) {
    liquid_.finish(model_, schedule_.fluidised_seconds());
    if (!warn_of_plugs()) bed_.look_for_standing_bed();
  }
}

void Recorder::run_ended() const {
  if (const std::string sentence = law_range_.sentence(); !sentence.empty())
    spdlog::log(law_range_.often_outside() ? spdlog::level::warn : spdlog::level::info, "{}: {}", run_title(scene_),
                sentence);
}

bool Recorder::warn_of_plugs() const {
  const fluid::Liquid& liquid = model_.liquid();
  if (!liquid.two_way() || liquid.grid().cells() > 1) return false;
  const std::string warning = describe(find_plugs(model_), scene_.liquid.superficial_velocity);
  if (warning.empty()) return false;
  spdlog::warn("{}: at {:g} s {}", run_title(scene_), schedule_.fluidised_seconds(), warning);
  return true;
}

void Recorder::write_snapshot() const {
  const auto folder = directory_ / "snapshots";
  make_output_folder(folder);
  const double time = schedule_.fluidised_seconds();
  io::write_particles_vtkhdf(io::snapshot_file(folder, "particles", time), model_.particles(), time);
  io::write_snapshot_series(folder, "particles");
  const fluid::Liquid& liquid = model_.liquid();
  if (!liquid.two_way()) return;
  io::write_liquid_vtkhdf(io::snapshot_file(folder, "liquid", time), liquid.grid(), model_.coupling().void_fraction(),
                          model_.coupling().cell_velocity(), liquid.pressure(), time);
  io::write_snapshot_series(folder, "liquid");
}

void Recorder::exchange(io::StateGroup& state) {
  state.part("drop_record", [&](io::StateGroup& group) { drop_.exchange(group); });
  state.part("force_balance", [&](io::StateGroup& group) { balance_.exchange(group); });
  state.part("law_range", [&](io::StateGroup& group) { law_range_.exchange(group); });
}

}  // namespace slfb::simulation
