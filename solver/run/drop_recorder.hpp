#pragma once

#include <array>
#include <string>

#include "solver/io/run_result.hpp"
#include "solver/io/state_group.hpp"
#include "solver/run/drop_protocol.hpp"
#include "solver/run/model.hpp"

namespace slfb::simulation {

/// Samples of the dropped sphere, and pictures of all spheres on the way of the first one.
class DropRecorder {
 public:
  /// \param result is filled; it must outlive the recorder
  explicit DropRecorder(RunResult& result) : result_(result) {}

  /// Adds the contact force of the last liquid step to the mean of the next sample.
  void end_step(const Model& model);
  /// A sphere of this species was released, `time` [s] after the start of fluidisation.
  void start_drop(const Model& model, const std::string& species, double time);
  /// One sample, `time` [s] after the release.
  void sample(Model& model, double time);
  /// Pictures of the first drop: when the sphere enters the bed, halfway down, and at the end of its way.
  void take_snapshots(const Model& model, bool fall_is_over, double time);
  /// The sphere touched the bottom `time` [s] after its release.
  void arrived(double time) { result_.drops.back().bottom_time = time; }

  void exchange(io::StateGroup& group);

 private:
  void take_snapshot(const Model& model, const std::string& moment, double time);

  RunResult& result_;
  std::array<double, 3> contact_force_{};  ///< sum over the liquid steps since the last sample [N]
  double steps_ = 0.0;                     ///< in the sum
};

}  // namespace slfb::simulation
