#include "experiments/quantities/analysis.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "correlations/materials.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Quantile of Student's t that bounds the central 95 %.
double student_t_95(double degrees_of_freedom) { return gsl_cdf_tdist_Pinv(0.975, degrees_of_freedom); }

double mean_of(std::span<const double> values) { return gsl_stats_mean(values.data(), 1, values.size()); }

/// The part of a history that belongs to a passage.
std::span<const double> during(const std::vector<double>& history, const Passage& passage) {
  return std::span(history).subspan(passage.begin, passage.end - passage.begin);
}

double mean_magnitude(std::span<const double> values) {
  return std::transform_reduce(values.begin(), values.end(), 0.0, std::plus{}, [](double v) { return std::abs(v); }) /
         static_cast<double>(values.size());
}

double horizontal_path(const DropSeries& drop, const Passage& passage) {
  double path = 0.0;
  for (std::size_t i = passage.begin + 1; i < passage.end; ++i) {
    path += std::hypot(drop.x[i] - drop.x[i - 1], drop.y[i] - drop.y[i - 1]);
  }
  return path;
}

/// The last fifth of the fall from release to one diameter above the bed, where the sphere has long reached its
/// terminal velocity (its relaxation length is a few centimetres) and does not feel the bed yet.
std::optional<Passage> terminal_stretch(const DropSeries& drop, const DropSurroundings& surroundings) {
  if (drop.z.empty()) return std::nullopt;
  const double end_height = surroundings.bed_top + surroundings.sphere_diameter;
  const double begin_height = end_height + 0.2 * (drop.z.front() - end_height);
  if (begin_height <= end_height) return std::nullopt;
  const auto below = [&](double height) {
    return static_cast<std::size_t>(std::find_if(drop.z.begin(), drop.z.end(), [&](double z) { return z < height; }) -
                                    drop.z.begin());
  };
  const Passage stretch{below(begin_height), below(end_height)};
  if (stretch.end < stretch.begin + 3) return std::nullopt;
  return stretch;
}

/// Mean speed of fall over the last second of the record, or over all of a shorter one.
double final_speed(const DropSeries& drop) {
  const auto first = std::lower_bound(drop.time.begin(), drop.time.end(), drop.time.back() - 1.0);
  const auto index = static_cast<std::size_t>(first - drop.time.begin());
  const double duration = drop.time.back() - drop.time[index];
  return duration > 0.0 ? std::abs(drop.z.back() - drop.z[index]) / duration : nan;
}

/// From its first contact, half a sample after the last one without, to the end. Empty where samples are further apart
/// than 2 ms, the fall in which is more than what is measured: committed drops are thinned.
std::optional<double> sinking_of(const DropSeries& drop) {
  constexpr double coarsest_interval = 2e-3;
  const auto touched = std::ranges::find_if(drop.cumulative_contacts, [](double count) { return count > 0.0; });
  if (touched == drop.cumulative_contacts.end() || touched == drop.cumulative_contacts.begin()) return std::nullopt;
  const auto before = static_cast<std::size_t>(touched - drop.cumulative_contacts.begin()) - 1;
  const double interval = drop.time[before + 1] - drop.time[before];
  if (interval > coarsest_interval) return std::nullopt;
  return drop.z[before] + 0.5 * interval * drop.velocity_z[before] - drop.z.back();
}

}  // namespace

double integrated_autocorrelation_time(std::span<const double> values) {
  const std::size_t size = values.size();
  if (size < 2) return 1.0;
  const double mean = mean_of(values);
  const auto covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < size; ++i) sum += (values[i] - mean) * (values[i + lag] - mean);
    return sum / static_cast<double>(size - lag);
  };
  const double variance = covariance(0);
  if (!(variance > 0.0)) return 1.0;
  double time = 1.0;
  std::size_t window = 1;
  for (; window < size / 2; ++window) {
    time += 2.0 * covariance(window) / variance;
    if (static_cast<double>(window) >= 2.5 * time) break;
  }
  const double bias_correction = 1.0 + static_cast<double>(2 * window + 1) / static_cast<double>(size);
  return std::max(1.0, time * bias_correction);
}

std::size_t transient_length(std::span<const double> values) {
  constexpr std::size_t batch = 5;
  const std::size_t batches = values.size() / batch;
  if (batches < 4) return 0;
  std::vector<double> means(batches);
  for (std::size_t j = 0; j < batches; ++j) means[j] = mean_of(values.subspan(j * batch, batch));

  std::size_t best = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t cut = 0; cut <= batches / 2; ++cut) {
    const auto rest = static_cast<double>(batches - cut);
    const double squares = gsl_stats_tss(means.data() + cut, 1, batches - cut);
    const double squared_error = squares / (rest * rest);
    if (squared_error < smallest) {
      smallest = squared_error;
      best = cut;
    }
  }
  return best * batch;
}

SeriesEstimate estimate_mean(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("estimate_mean: the series is empty");
  SeriesEstimate estimate;
  estimate.mean = mean_of(values);
  estimate.autocorrelation_time = integrated_autocorrelation_time(values);
  const auto size = static_cast<double>(values.size());
  estimate.effective_samples = size / estimate.autocorrelation_time;
  if (estimate.effective_samples < 2.0) {
    estimate.half_width = nan;
    return estimate;
  }
  // The plain variance of a correlated series is too small by the factor 1 − τ/N.
  const double variance = gsl_stats_variance_with_fixed_mean(values.data(), 1, values.size(), estimate.mean) /
                          (1.0 - 1.0 / estimate.effective_samples);
  estimate.half_width =
      student_t_95(estimate.effective_samples - 1.0) * std::sqrt(variance / estimate.effective_samples);
  return estimate;
}

SeriesEstimate estimate_steady_mean(std::span<const double> values) {
  const std::size_t transient = transient_length(values);
  SeriesEstimate estimate = estimate_mean(values.subspan(transient));
  estimate.discarded = transient;
  return estimate;
}

ReplicateEstimate estimate_replicates(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("estimate_replicates: there is no sample");
  ReplicateEstimate estimate;
  estimate.samples = values.size();
  estimate.mean = mean_of(values);
  if (values.size() == 1) {
    estimate.half_width = estimate.standard_deviation = nan;
    return estimate;
  }
  const auto size = static_cast<double>(values.size());
  estimate.standard_deviation = gsl_stats_sd_m(values.data(), 1, values.size(), estimate.mean);
  estimate.half_width = student_t_95(size - 1.0) * estimate.standard_deviation / std::sqrt(size);
  return estimate;
}

double standard_error(double half_width, std::size_t samples) {
  if (samples < 2) throw std::invalid_argument("standard_error: a single sample has none");
  return half_width / student_t_95(static_cast<double>(samples) - 1.0);
}

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("fit_line: x and y have different lengths");
  if (x.size() < 2) throw std::invalid_argument("fit_line: a line needs two points");
  LineFit fit;
  fit.points = x.size();
  double variance_intercept = 0.0, covariance = 0.0, variance_slope = 0.0, residual_squares = 0.0;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &fit.intercept, &fit.slope, &variance_intercept, &covariance,
                 &variance_slope, &residual_squares);
  const double total_squares = gsl_stats_tss(y.data(), 1, y.size());
  fit.r_squared = total_squares > 0.0 ? 1.0 - residual_squares / total_squares : 1.0;
  return fit;
}

bool rises_through_window(const DropSeries& drop, double bottom) { return !drop.z.empty() && drop.z.front() < bottom; }

std::optional<ClassificationFit> fit_classification(const DropSeries& drop, double bottom, double top,
                                                    double release_clock) {
  const bool rises = rises_through_window(drop, bottom);
  const auto first_beyond = [&](double height) {
    const auto found = std::ranges::find_if(drop.z, [&](double z) { return rises ? z > height : z < height; });
    return static_cast<std::size_t>(found - drop.z.begin());
  };
  const std::size_t begin = first_beyond(rises ? bottom : top);
  const std::size_t end = first_beyond(rises ? top : bottom);
  if (end == drop.z.size() || end < begin + 3) return std::nullopt;
  std::vector<double> clock(drop.time.begin() + static_cast<std::ptrdiff_t>(begin),
                            drop.time.begin() + static_cast<std::ptrdiff_t>(end));
  for (double& time : clock) time += release_clock;
  const LineFit line = fit_line(clock, std::span(drop.z).subspan(begin, end - begin));
  return ClassificationFit{-line.slope, line.intercept, line.r_squared, line.points};
}

double voidage_from_height(double solids_volume, double area, double height) {
  return 1.0 - solids_volume / (area * height);
}

std::optional<Passage> bed_passage(const DropSeries& drop, double bed_top) {
  const auto entry = std::find_if(drop.z.begin(), drop.z.end(), [&](double z) { return z < bed_top; });
  const auto begin = static_cast<std::size_t>(entry - drop.z.begin());
  std::size_t end = drop.z.size();
  if (drop.bottom_time >= 0.0) {
    end = static_cast<std::size_t>(std::lower_bound(drop.time.begin(), drop.time.end(), drop.bottom_time) -
                                   drop.time.begin());
  } else if (begin == 0 && !drop.z.empty() && drop.z.back() > bed_top) {
    const auto exit = std::ranges::find_if(drop.z, [&](double z) { return z > bed_top; });
    end = static_cast<std::size_t>(exit - drop.z.begin());
  }
  if (end < begin + 2) return std::nullopt;
  return Passage{begin, end};
}

DropStatistics analyse_drop(const DropSeries& drop, const DropSurroundings& surroundings) {
  DropStatistics statistics;
  if (drop.time.empty()) return statistics;
  const bool at_bottom = drop.bottom_time >= 0.0;
  if (at_bottom) statistics.time_to_bottom = drop.bottom_time;
  statistics.time_followed = at_bottom ? drop.bottom_time : drop.time.back();
  statistics.classification = surroundings.classification;

  if (const auto stretch = terminal_stretch(drop, surroundings)) {
    statistics.terminal_velocity =
        mean_of(during(drop.liquid_velocity_z, *stretch)) - mean_of(during(drop.velocity_z, *stretch));
    statistics.terminal_reynolds = mean_of(during(drop.reynolds, *stretch));
  }
  if (!at_bottom && final_speed(drop) < resting_speed) {
    statistics.rests = true;
    if (drop.z.back() < drop.z.front()) statistics.sinking = sinking_of(drop);
    // Not deeper than itself and one layer of the bed, it lies in a hollow of the surface at most: what it met is its
    // landing, not a passage.
    const double surface = surroundings.bed_top + 0.5 * surroundings.bed_diameter;
    const double depth = surface - (drop.z.back() - 0.5 * surroundings.sphere_diameter);
    if (depth < surroundings.bed_diameter + surroundings.sphere_diameter) return statistics;
  }

  const auto passage = bed_passage(drop, surroundings.bed_top);
  if (!passage) return statistics;
  const double volume = std::numbers::pi / 6.0 * std::pow(surroundings.sphere_diameter, 3);
  const double weight = volume * surroundings.sphere_density * gravitational_acceleration;
  const std::size_t last = passage->end - 1;

  const auto force = during(drop.contact_force, *passage);
  const double mean_force = mean_of(force);
  const double mean_drag = mean_magnitude(during(drop.drag_force_z, *passage));
  statistics.force_ratio = mean_force / weight;
  statistics.force_ratio_of_mean = std::hypot(mean_of(during(drop.contact_force_mean_x, *passage)),
                                              mean_of(during(drop.contact_force_mean_y, *passage)),
                                              mean_of(during(drop.contact_force_mean_z, *passage))) /
                                   weight;
  statistics.peak_force_ratio = *std::max_element(force.begin(), force.end()) / weight;
  statistics.contact_fraction =
      static_cast<double>(std::count_if(force.begin(), force.end(), [](double value) { return value > 0.0; })) /
      static_cast<double>(force.size());
  statistics.drag_ratio = mean_drag / weight;
  statistics.pressure_gradient_ratio = mean_of(during(drop.pressure_force_z, *passage)) / weight;
  if (mean_drag > 0.0) statistics.collision_to_drag_ratio = mean_force / mean_drag;

  const auto contacts = during(drop.contacts, *passage);
  statistics.mean_contacts = mean_of(contacts);
  statistics.maximum_contacts = *std::max_element(contacts.begin(), contacts.end());
  statistics.collision_frequency = (drop.cumulative_contacts[last] - drop.cumulative_contacts[passage->begin]) /
                                   (drop.time[last] - drop.time[passage->begin]);

  const auto voidage = during(drop.voidage, *passage);
  statistics.local_voidage_mean = mean_of(voidage);
  statistics.local_voidage_minimum = *std::min_element(voidage.begin(), voidage.end());
  statistics.local_voidage_maximum = *std::max_element(voidage.begin(), voidage.end());
  const double height = drop.z[passage->begin] - drop.z[last];
  if (height > 0.0) statistics.lateral_travel = horizontal_path(drop, *passage) / height;
  return statistics;
}

std::vector<double> plane_vorticity(const PlaneField& plane) {
  if (plane.velocity_x.size() != plane.voidage.size() || plane.velocity_z.size() != plane.voidage.size()) return {};
  const std::size_t columns = plane.x.size(), rows = plane.z.size();
  std::vector<double> vorticity(plane.voidage.size(), nan);
  for (std::size_t row = 1; row + 1 < rows; ++row) {
    for (std::size_t column = 1; column + 1 < columns; ++column) {
      const std::size_t here = row * columns + column;
      vorticity[here] =
          (plane.velocity_x[here + columns] - plane.velocity_x[here - columns]) /
              (plane.z[row + 1] - plane.z[row - 1]) -
          (plane.velocity_z[here + 1] - plane.velocity_z[here - 1]) / (plane.x[column + 1] - plane.x[column - 1]);
    }
  }
  return vorticity;
}

namespace {

double wall_excess_of(const PlaneField& plane, std::size_t rows) {
  const std::size_t columns = plane.x.size();
  const double half_width = std::max(std::abs(plane.x.front()), std::abs(plane.x.back()));
  std::vector<double> outer, inner;
  for (std::size_t index = 0; index < rows * columns; ++index) {
    if (!std::isfinite(plane.voidage[index])) continue;
    const std::size_t column = index % columns;
    if (column == 0 || column + 1 == columns) outer.push_back(plane.voidage[index]);
    if (std::abs(plane.x[column]) < 0.5 * half_width) inner.push_back(plane.voidage[index]);
  }
  return outer.empty() || inner.empty() ? nan : mean_of(outer) - mean_of(inner);
}

/// Part of a ball that no other sphere of the snapshot fills, by the points of a lattice in it.
double voidage_of_ball(const Snapshot& snapshot, double x, double y, double z, double radius) {
  constexpr int points = 10;  // on either side of the centre: some 4000 in the ball
  std::size_t inside = 0, empty = 0;
  const auto foreign = static_cast<std::size_t>(snapshot.foreign);
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < snapshot.x.size(); ++k)
    if (k != foreign &&
        std::hypot(snapshot.x[k] - x, snapshot.y[k] - y, snapshot.z[k] - z) < radius + snapshot.radius[k])
      near.push_back(k);
  for (int i = -points; i <= points; ++i)
    for (int j = -points; j <= points; ++j)
      for (int k = -points; k <= points; ++k) {
        if (i * i + j * j + k * k > points * points) continue;
        ++inside;
        const double step = radius / points, px = x + i * step, py = y + j * step, pz = z + k * step;
        empty += std::ranges::none_of(near, [&](std::size_t s) {
          return std::hypot(snapshot.x[s] - px, snapshot.y[s] - py, snapshot.z[s] - pz) < snapshot.radius[s];
        });
      }
  return static_cast<double>(empty) / static_cast<double>(inside);
}

}  // namespace

std::optional<double> wake_excess(const std::vector<Snapshot>& snapshots) {
  const auto found = std::ranges::find(snapshots, "halfway", &Snapshot::moment);
  if (found == snapshots.end() || found->foreign < 0) return std::nullopt;
  const Snapshot& snapshot = *found;
  const auto foreign = static_cast<std::size_t>(snapshot.foreign);
  if (foreign >= snapshot.z.size()) return std::nullopt;
  const double radius = snapshot.radius[foreign], z = snapshot.z[foreign];
  double top = 0.0;
  for (std::size_t k = 0; k < snapshot.z.size(); ++k)
    if (k != foreign) top = std::max(top, snapshot.z[k]);
  if (z - 3.0 * radius < 0.0 || z + 3.0 * radius > top) return std::nullopt;
  const auto voidage = [&](double height) {
    return voidage_of_ball(snapshot, snapshot.x[foreign], snapshot.y[foreign], height, radius);
  };
  return voidage(z + 2.0 * radius) - voidage(z - 2.0 * radius);
}

std::optional<PlaneStatistics> analyse_plane(const PlaneField& plane, double bed_top) {
  const std::size_t columns = plane.x.size();
  const auto rows =
      static_cast<std::size_t>(std::lower_bound(plane.z.begin(), plane.z.end(), bed_top) - plane.z.begin());
  std::vector<double> voidage;
  for (std::size_t index = 0; index < rows * columns; ++index) {
    if (std::isfinite(plane.voidage[index])) voidage.push_back(plane.voidage[index]);
  }
  if (voidage.empty()) return std::nullopt;
  PlaneStatistics statistics{gsl_stats_sd_with_fixed_mean(voidage.data(), 1, voidage.size(), mean_of(voidage)), nan,
                             nan, wall_excess_of(plane, rows)};
  const auto vorticity = plane_vorticity(plane);
  if (vorticity.empty()) return statistics;

  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  double fastest = 0.0;
  for (std::size_t here = 0; here < rows * columns; ++here) {
    const double speed = std::hypot(plane.velocity_x[here], plane.velocity_z[here]);
    if (std::isfinite(speed)) fastest = std::max(fastest, speed);
    // The uppermost row of the bed takes its gradient from the clear liquid above.
    if (here >= (rows - 1) * columns || !std::isfinite(vorticity[here])) continue;
    lowest = std::min(lowest, vorticity[here]);
    highest = std::max(highest, vorticity[here]);
  }
  statistics.speed_maximum = fastest;
  if (highest >= lowest) statistics.vorticity_range = highest - lowest;
  return statistics;
}

}  // namespace slfb
