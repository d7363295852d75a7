#pragma once

#include <cstdint>

#include "solver/coupling/force_balance.hpp"
#include "solver/io/run_result.hpp"
#include "solver/io/state_group.hpp"
#include "solver/run/model.hpp"

namespace slfb::simulation {

/// Means of the vertical forces on spheres and liquid together between two samples of the bed, and how far they are
/// from balance in the worst step (coupling::ForceBalance).
class MeanForceBalance {
 public:
  /// \param scene of the model; must outlive the balance
  explicit MeanForceBalance(const Scene& scene) : scene_(scene) {}

  /// To be called before and after each liquid step of the model. The first step gives no balance, because the liquid's
  /// momentum before it is not known; if the spheres do not act on the liquid, no step does.
  void start_step(const Model& model);
  void end_step(const Model& model);
  /// Spheres were put in or taken out. Liquid appears or vanishes there, so that the next step is left out.
  void spheres_changed() { momentum_is_known_ = false; }

  /// Appends the means [N] and the largest residual over the weight [-] to the bed's series, and starts anew. The
  /// weight is the buoyant one of the spheres, at least a thousandth of the whole one.
  void take(BedSeries& bed);

  void exchange(io::StateGroup& group);

 private:
  const Scene& scene_;
  coupling::ForceBalance sum_;
  double steps_ = 0.0;  ///< in the sum
  double largest_residual_ = 0.0;
  double liquid_momentum_ = 0.0, sphere_momentum_ = 0.0;  ///< after the last step, before the present one [kg m/s]
  bool momentum_is_known_ = false;
};

}  // namespace slfb::simulation
