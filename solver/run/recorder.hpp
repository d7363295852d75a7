#pragma once

#include <filesystem>
#include <string>

#include "solver/io/run_result.hpp"
#include "solver/io/state_group.hpp"
#include "solver/run/bed_recorder.hpp"
#include "solver/run/drop_protocol.hpp"
#include "solver/run/drop_recorder.hpp"
#include "solver/run/law_range.hpp"
#include "solver/run/liquid_recorder.hpp"
#include "solver/run/mean_force_balance.hpp"
#include "solver/run/model.hpp"
#include "solver/run/schedule.hpp"

namespace slfb::simulation {

/// Decides what is recorded when, at the intervals of the scene, and writes snapshots for ParaView.
///
/// It reads the model and never changes its motion. Time is that of Schedule::fluidised_seconds().
class Recorder {
 public:
  /// \param result is filled; all arguments must outlive the recorder
  /// \param directory of the run; snapshots go to its folder "snapshots"
  Recorder(const Scene& scene, Model& model, const Schedule& schedule, const std::filesystem::path& directory,
           RunResult& result);

  /// Around each liquid step after settling.
  void start_step() { balance_.start_step(model_); }
  void end_step();
  void spheres_changed() { balance_.spheres_changed(); }
  /// What is due after a liquid step. Throws std::runtime_error if a snapshot cannot be written.
  void record();

  void drop_started(const std::string& species);
  /// After each liquid step in which a sphere falls; `at_bottom`: it touches the bottom, `over`: it is taken out.
  void record_drop(const DropProtocol& drops, bool at_bottom, bool over);

  void stage_ended();

  /// What the user should know of the whole run.
  void run_ended() const;

  void exchange(io::StateGroup& state);

 private:
  void write_snapshot() const;
  /// Of a bed in a one-dimensional liquid. Returns whether there was something to warn of.
  bool warn_of_plugs() const;

  const Scene& scene_;
  Model& model_;
  const Schedule& schedule_;
  std::filesystem::path directory_;
  BedRecorder bed_;
  DropRecorder drop_;
  LiquidRecorder liquid_;
  MeanForceBalance balance_;
  LawRange law_range_;
  RunResult& result_;
};

}  // namespace slfb::simulation
