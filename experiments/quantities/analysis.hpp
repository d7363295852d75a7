#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "solver/io/run_result.hpp"

/// Statistics of runs: from recorded series to numbers with 95 % confidence intervals.
namespace slfb {

/// Mean of a stationary series whose samples are correlated.
struct SeriesEstimate {
  double mean = 0.0;
  double half_width = 0.0;            ///< of the 95 % interval; NaN when fewer than two effective samples are left
  double autocorrelation_time = 1.0;  ///< integrated, in samples; 1 for white noise
  double effective_samples = 0.0;     ///< number of samples over autocorrelation_time
  std::size_t discarded = 0;          ///< samples left out at the start as transient
};

/// Integrated autocorrelation time τ = 1 + 2 Σ ρ_k in samples, summed up to the first window W ≥ 5 τ(W)/2 (Sokal 1997)
/// and corrected for the bias of the window (Wolff 2004, Comput. Phys. Commun. 156, 143, eq. 49). At least 1.
double integrated_autocorrelation_time(std::span<const double> values);

/// Length of the start-up transient by the rule MSER-5 (White 1997, Simulation 69, 323): the series is cut into
/// batches of five, and the cut is where the standard error of the mean of the remaining batches is smallest. Only
/// the first half of the series is searched, so that a drifting series keeps half of its samples.
std::size_t transient_length(std::span<const double> values);

/// Mean and 95 % interval of a series taken to be stationary: Student's t with N/τ − 1 degrees of freedom.
SeriesEstimate estimate_mean(std::span<const double> values);

/// The same after cutting off the transient.
SeriesEstimate estimate_steady_mean(std::span<const double> values);

/// Mean of independent replicates.
struct ReplicateEstimate {
  double mean = 0.0;
  double half_width = 0.0;          ///< of the 95 % t-interval; NaN for a single sample
  double standard_deviation = 0.0;  ///< of the samples; NaN for a single one
  std::size_t samples = 0;
};

/// Mean and 95 % t-interval of independent samples. Throws std::invalid_argument when there is none.
ReplicateEstimate estimate_replicates(std::span<const double> values);

/// Standard error of a mean of independent samples, from the half-width of its 95 % t-interval. Throws
/// std::invalid_argument for fewer than two samples.
double standard_error(double half_width, std::size_t samples);

/// Least-squares straight line y = intercept + slope·x.
struct LineFit {
  double slope = 0.0;
  double intercept = 0.0;
  double r_squared = 0.0;
  std::size_t points = 0;
};

/// Throws std::invalid_argument when there are fewer than two points or lengths differ.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

/// Straight line z = intercept − velocity·t through the first passage of a window of height, downwards or upwards.
struct ClassificationFit {
  double velocity = 0.0;   ///< V_2, positive downwards, negative of a sphere that rises [m/s]
  double intercept = 0.0;  ///< on the clock whose reading at the release is `release_clock` [m]
  double r_squared = 0.0;
  std::size_t points = 0;
};

/// Whether a drop crosses a window from below: its sphere is released below the window's bottom [m].
bool rises_through_window(const DropSeries& drop, double bottom);

/// Fits the samples of the passage through the window of height from `bottom` to `top` [m]: from the first one below
/// its top to the last one before the sphere is first below its bottom; of a sphere that is released below the window,
/// from the first one above its bottom to the last one before it is first above its top. `release_clock` is the time
/// shown at release [s]. Empty when the sphere does not pass the window or leaves fewer than three samples there.
std::optional<ClassificationFit> fit_classification(const DropSeries& drop, double bottom, double top,
                                                    double release_clock);

/// Voidage of a bed of `solids_volume` that fills a column of cross-section `area` up to `height` evenly.
double voidage_from_height(double solids_volume, double area, double height);

/// Samples of a drop from entering the bed to the bottom: [begin, end).
struct Passage {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Begins with the first sample whose centre is below the top of the bed and ends with the first touch of the
/// distributor, or with the record when there is none; of a sphere that is released in the bed and rises out of it,
/// where it is first above the top. Empty when the sphere does not come down to the bed.
std::optional<Passage> bed_passage(const DropSeries& drop, double bed_top);

/// What the statistics of a drop need to know beside its history.
struct DropSurroundings {
  double bed_top = 0.0;                                  ///< mean height of the top of the bed before the drop [m]
  double bed_diameter = 0.0;                             ///< of the fluidised particles [m]
  double sphere_diameter = 0.0;                          ///< [m]
  double sphere_density = 0.0;                           ///< [kg/m³]
  std::optional<ClassificationFit> classification = {};  ///< of the drop, see classification_of
};

/// Averages of one drop. Passage quantities run from entering the bed to the bottom (the paper's "entire settling
/// process") and are empty when the sphere does not reach the bed, or comes to rest on it, no deeper than
/// its own diameter and one of the bed.
struct DropStatistics {
  std::optional<ClassificationFit> classification;
  std::optional<double> time_to_bottom;       ///< from release [s]; empty when the bottom is not reached
  double time_followed = 0.0;                 ///< to the bottom, or to the end of the record [s]
  std::optional<double> terminal_velocity;    ///< slip to the liquid above the bed, last fifth of the free fall [m/s]
  std::optional<double> terminal_reynolds;    ///< Eq. 25, over the same stretch [-]
  bool rests = false;                         ///< has come to rest above the bottom
  std::optional<double> sinking;              ///< from its first contact to where it comes to rest [m]
  std::optional<double> collision_frequency;  ///< new contacts per second of passage [1/s]
  std::optional<double> force_ratio;          ///< mean of |F_c| over m g [-]
  std::optional<double> force_ratio_of_mean;  ///< |mean of F_c| over m g [-]
  std::optional<double> peak_force_ratio;     ///< largest |F_c| over m g [-]
  std::optional<double> drag_ratio;           ///< mean |F_d,z| over m g [-]
  std::optional<double> pressure_gradient_ratio;  ///< mean of −V ∂p/∂z over m g, static part included [-]
  std::optional<double> collision_to_drag_ratio;  ///< mean |F_c| over mean |F_d,z| [-]
  std::optional<double> mean_contacts;
  std::optional<double> maximum_contacts;
  std::optional<double> contact_fraction;  ///< part of the passage in which the sphere touches another [-]
  std::optional<double> lateral_travel;    ///< path in the horizontal plane over the height passed [-]
  std::optional<double> local_voidage_mean, local_voidage_minimum, local_voidage_maximum;  ///< at the sphere [-]
};

DropStatistics analyse_drop(const DropSeries& drop, const DropSurroundings& surroundings);

/// A sphere that ends its record slower than this is taken to rest on the bed [m/s]. The slowest fall through a bed
/// that is published, 0.2 m in 30 s (Peng et al. 2014, Fig. 7), is seven times as fast.
inline constexpr double resting_speed = 1e-3;

/// Unevenness of the plane y = 0 below the top of the bed.
struct PlaneStatistics {
  double voidage_deviation = 0.0;  ///< standard deviation of the voidage over the cells [-]
  double vorticity_range = 0.0;    ///< largest minus smallest plane_vorticity (Fig. 14) [1/s]; NaN without velocities
  double speed_maximum = 0.0;      ///< largest |u| of the interstitial liquid [m/s]; NaN without velocities
  double wall_excess = 0.0;        ///< mean voidage of the outermost cells less that of the middle half [-]
};

/// Vorticity about y, ∂u_x/∂z − ∂u_z/∂x, by central differences at the cells of the plane [1/s]; not a number at the
/// edges and beside cells outside the column. Empty when the plane has no velocities.
std::vector<double> plane_vorticity(const PlaneField& plane);

/// Empty when no cell lies below `bed_top`.
std::optional<PlaneStatistics> analyse_plane(const PlaneField& plane, double bed_top);

/// Voidage behind the dropped sphere less that before it [-]: of two balls of its own radius that touch it from above
/// and from below, in the snapshot halfway through the bed. Empty without such a snapshot, and where a ball is not
/// inside the bed.
std::optional<double> wake_excess(const std::vector<Snapshot>& snapshots);

}  // namespace slfb
