#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "experiments/quantities/analysis.hpp"

/// Statistics of samples that are few, come from several beds, are yes or no, or end before the event.
namespace slfb {

/// Mean of drops that were made into several beds.
struct PooledEstimate {
  double mean = 0.0;
  double half_width = 0.0;  ///< of the 95 % interval; NaN for a single sample
  double scatter = 0.0;     ///< standard deviation of one drop into any bed; NaN for a single sample
  std::size_t samples = 0;  ///< independent ones: the interval has samples − 1 degrees of freedom
};

/// Drops into one bed share what that bed has of its own. An F test at the level of 25 % asks whether beds differ by
/// more than the drops within them; where they do, the mean is that of the bed means and its interval comes from their
/// scatter, otherwise all drops are samples of one kind. The level is that of Bozivich, Bancroft & Hartley (1956, Ann.
/// Math. Statist. 27, 1017), who show that it keeps the error rate near the stated one.
/// Throws std::invalid_argument when there is no sample.
PooledEstimate pool_beds(std::span<const std::vector<double>> beds);

/// The same of samples that are whole multiples of a step: they scatter by that of the rounding at least, step/√12
/// (JCGM 100:2008, F.2.2.1), so that two equal counts have no interval of width zero.
PooledEstimate with_resolution(PooledEstimate estimate, double step);

/// Mean of the undisturbed beds of several runs, each with the interval of its own series. Where these explain the
/// differences of the runs (chi-square test, the same level), the mean is weighted by them; otherwise the interval
/// comes from the scatter of the runs. Runs whose series are too short for an interval count only where no other does.
PooledEstimate pool_series(std::span<const SeriesEstimate> runs);

/// 95 % interval of a probability after `successes` of `trials` (Clopper & Pearson 1934, Biometrika 26, 404): of
/// width zero for no number of trials.
std::pair<double, double> share_interval(std::size_t successes, std::size_t trials);

/// A sample, or what is known of one that was not followed to its end.
struct BoundedSample {
  enum class Kind { exact, at_least, at_most };
  double value = 0.0;
  Kind kind = Kind::exact;
};

/// Median with the 95 % interval that order statistics give without any assumption on the distribution. A side is
/// infinite where the samples do not bound it: five drops of which none arrived within 15 s say that half of all need
/// more than 15 s. With an infinite side the level is that of the finite side alone.
struct MedianEstimate {
  double value = 0.0;  ///< the median, or the bound that is known of it
  double lower = 0.0, upper = 0.0;
};

/// Throws std::invalid_argument when there is no sample, or when there are bounds on both sides.
MedianEstimate estimate_median(std::span<const BoundedSample> samples);

/// Change of a series at its end: mean of its last quarter less that of the quarter before. 0 for fewer than eight.
double change_at_the_end(std::span<const double> values);

}  // namespace slfb
