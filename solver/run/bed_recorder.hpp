#pragma once

#include "solver/io/run_result.hpp"
#include "solver/run/model.hpp"

namespace slfb::simulation {

/// Samples of the bed: its spheres without the dropped one.
class BedRecorder {
 public:
  /// \param result is filled; it must outlive the recorder, as the scene must
  BedRecorder(const Scene& scene, RunResult& result) : scene_(scene), result_(result) {}

  /// Height and voidage of the bed at the end of settling; nothing without spheres. Spheres that are lighter than the
  /// liquid, if they have settled `in_liquid`, hang under the lid. Warns if the bed has not come to
  /// rest.
  void measure_packed_bed(const Model& model, bool in_liquid);
  /// One sample, `time` [s] after the start of fluidisation; all but the force balance. False, and no sample, if no
  /// sphere of the bed is left; \param superficial_velocity of the liquid that enters [m/s]. Warns once if the contact
  /// network is too stiff for the spheres' time step.
  bool sample(const Model& model, double time, double superficial_velocity);
  /// At the end of the last fluidise stage: warns of a bed that stands still although the liquid flows fast enough.
  void look_for_standing_bed() const;

 private:
  void sample_contact_forces(const Model& model, double time);

  const Scene& scene_;
  RunResult& result_;
  bool warned_of_network_ = false;
};

}  // namespace slfb::simulation
