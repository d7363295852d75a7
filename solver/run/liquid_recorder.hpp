#pragma once

#include <optional>

#include "solver/io/run_result.hpp"
#include "solver/run/fluctuation_window.hpp"
#include "solver/run/model.hpp"

namespace slfb::simulation {

/// Liquid in the plane y = 0 at the end of fluidisation, and the fluctuation of its velocity before. Records nothing
/// if the spheres do not act on the liquid.
class LiquidRecorder {
 public:
  /// \param result is filled; it must outlive the recorder
  LiquidRecorder(const Scene& scene, const Model& model, RunResult& result);

  /// Adds the present velocities to the samples of the fluctuation; `time` on the clock of BedSeries [s].
  void sample_fluctuation(const Model& model, double time);
  /// At the end of the fluidise stage: the plane, and the samples reduced to means and deviations.
  void finish(const Model& model, double time);

 private:
  void record_plane(const Model& model, double time);

  RunResult& result_;
  std::optional<FluctuationWindow> window_;
};

}  // namespace slfb::simulation
