#pragma once

#include <vector>

#include "solver/coupling/diffusion_smoothing.hpp"
#include "solver/coupling/lone_spheres.hpp"
#include "solver/coupling/volume_shares.hpp"
#include "solver/dem/engine.hpp"
#include "solver/fluid/liquid.hpp"
#include "solver/support/named_fields.hpp"

namespace slfb::coupling {

/// How much liquid each cell holds at both ends of a liquid step: what the spheres leave of it (Peng 2014, Eq. 29).
///
/// With a coupling.void_fraction_interval of several liquid steps the shares are those of where the spheres will be at
/// its end if they keep their velocities, and the liquid goes there evenly: no jump between intervals, no volume lost.
/// In one-way coupling the spheres displace nothing.
class LiquidVolumes {
 public:
  /// Scene and liquid must outlive the volumes.
  LiquidVolumes(const Scene& scene, const fluid::Liquid& liquid);

  /// Shares of the spheres and liquid at the end of the coming step. \param sphere_volume of each sphere [m³]
  /// \return whether the shares are new: false within an interval
  /// \throws std::invalid_argument if a sphere is larger than the largest of the scene's species
  bool start_step(const dem::Engine& engine, double time_step, const std::vector<double>& sphere_volume);
  /// The end of the step becomes the start of the next.
  void end_step() { before_.swap(now_); }
  /// A sphere has been put in or taken out: the next step sees no liquid displaced by that. Until then before() is that
  /// of the last step.
  void start_anew();

  /// Liquid per cell at the start and at the end of the step [m³]; empty before the first step and in one-way coupling.
  [[nodiscard]] const std::vector<double>& before() const { return before_; }
  [[nodiscard]] const std::vector<double>& now() const { return now_; }
  /// α per cell at the end of the step as the spheres see it, smoothed over coupling.smoothing_length [-].
  [[nodiscard]] const std::vector<double>& voidage() const { return voidage_; }

  /// Adds to `cells` what the liquid volumes lack within an interval of those that the spheres' shares leave [m³].
  void add_rest_of_interval(std::vector<double>& cells) const;

  [[nodiscard]] const VolumeShares& shares() const { return shares_; }
  [[nodiscard]] const LoneSpheres& lone() const { return lone_; }
  [[nodiscard]] DiffusionSmoothing& smoothing() { return smoothing_; }

  /// liquid_volume per cell [m³]; of an interval that is under way interval/steps (all, done), interval/liquid_at_start
  /// and _at_end per cell [m³], and interval/centre_x and so on per sphere [m].
  [[nodiscard]] NamedFields state() const;
  /// \throws std::runtime_error if a field is missing or has another length
  void restore(const NamedFields& state, const std::vector<double>& radius);

 private:
  void find_shares(const dem::VectorField& centres, const std::vector<double>& radii,
                   const std::vector<double>& sphere_volume, int threads);
  void start_interval(const dem::Engine& engine, double time_step, const std::vector<double>& sphere_volume);
  [[nodiscard]] int steps_per_interval() const;

  const Scene& scene_;
  const fluid::ColumnGrid& grid_;
  bool two_way_;
  VolumeShares shares_;
  LoneSpheres lone_;
  DiffusionSmoothing smoothing_;
  std::vector<double> before_, now_, voidage_, solid_;
  bool anew_ = true;  ///< the next step starts with the liquid that it ends with
  // The present interval: its steps, those done, the liquid at both ends, the spheres' centres at its end.
  int steps_ = 1, steps_done_ = 0;
  std::vector<double> at_start_, at_end_;
  dem::VectorField centres_;
};

}  // namespace slfb::coupling
