#include "experiments/quantities/samples.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace slfb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double level_of_differing_beds = 0.25;

double average(std::span<const double> values) { return gsl_stats_mean(values.data(), 1, values.size()); }

PooledEstimate of_replicates(std::span<const double> values) {
  const ReplicateEstimate estimate = estimate_replicates(values);
  return {estimate.mean, estimate.half_width, estimate.standard_deviation, estimate.samples};
}

}  // namespace

PooledEstimate pool_beds(std::span<const std::vector<double>> beds) {
  std::vector<double> all, means;
  double within = 0.0, squares_of_sizes = 0.0;
  for (const std::vector<double>& bed : beds) {
    if (bed.empty()) continue;
    all.insert(all.end(), bed.begin(), bed.end());
    means.push_back(average(bed));
    within += gsl_stats_tss_m(bed.data(), 1, bed.size(), means.back());
    squares_of_sizes += static_cast<double>(bed.size()) * static_cast<double>(bed.size());
  }
  if (all.empty()) throw std::invalid_argument("pool_beds: there is no sample");
  if (means.size() < 2 || all.size() == means.size()) return of_replicates(all);

  const auto bed_count = static_cast<double>(means.size()), size = static_cast<double>(all.size());
  const double between = gsl_stats_tss(all.data(), 1, all.size()) - within;
  const double mean_between = between / (bed_count - 1.0), mean_within = within / (size - bed_count);
  if (!(mean_between > 0.0)) return of_replicates(all);
  const double chance =
      mean_within > 0.0 ? gsl_cdf_fdist_Q(mean_between / mean_within, bed_count - 1.0, size - bed_count) : 0.0;
  if (chance > level_of_differing_beds) return of_replicates(all);

  PooledEstimate estimate = of_replicates(means);
  const double drops_of_a_bed = (size - squares_of_sizes / size) / (bed_count - 1.0);
  estimate.scatter = std::sqrt(mean_within + std::max(0.0, mean_between - mean_within) / drops_of_a_bed);
  return estimate;
}

PooledEstimate with_resolution(PooledEstimate estimate, double step) {
  if (estimate.samples < 2) return estimate;
  const auto samples = static_cast<double>(estimate.samples);
  const double rounding = step / std::sqrt(12.0);
  estimate.scatter = std::max(estimate.scatter, rounding);
  estimate.half_width =
      std::max(estimate.half_width, gsl_cdf_tdist_Pinv(0.975, samples - 1.0) * rounding / std::sqrt(samples));
  return estimate;
}

PooledEstimate pool_series(std::span<const SeriesEstimate> runs) {
  if (runs.empty()) throw std::invalid_argument("pool_series: there is no run");
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<SeriesEstimate> known;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(known),
               [](const SeriesEstimate& run) { return run.half_width > 0.0; });
  if (known.empty()) {
    std::vector<double> means;
    for (const SeriesEstimate& run : runs) means.push_back(run.mean);
    PooledEstimate estimate = of_replicates(means);
    // A single series without any fluctuation is known exactly.
    if (runs.size() == 1) estimate.half_width = runs.front().half_width;
    return estimate;
  }
  double weights = 0.0, mean = 0.0, effective = 0.0, scatter = 0.0;
  const auto error = [](const SeriesEstimate& run) {
    return standard_error(run.half_width, static_cast<std::size_t>(std::max(2.0, run.effective_samples)));
  };
  for (const SeriesEstimate& run : known) {
    weights += 1.0 / (error(run) * error(run));
    effective += run.effective_samples;
  }
  for (const SeriesEstimate& run : known) mean += run.mean / (error(run) * error(run) * weights);
  const auto samples = static_cast<std::size_t>(std::max(1.0, effective));
  if (known.size() == 1) return {known.front().mean, known.front().half_width, none, samples};
  for (const SeriesEstimate& run : known) scatter += std::pow((run.mean - mean) / error(run), 2);
  if (gsl_cdf_chisq_Q(scatter, static_cast<double>(known.size()) - 1.0) > level_of_differing_beds) {
    const double freedom = static_cast<double>(std::max<std::size_t>(2, samples)) - 1.0;
    return {mean, gsl_cdf_tdist_Pinv(0.975, freedom) / std::sqrt(weights), none, samples};
  }
  std::vector<double> means;
  for (const SeriesEstimate& run : known) means.push_back(run.mean);
  return of_replicates(means);
}

std::pair<double, double> share_interval(std::size_t successes, std::size_t trials) {
  if (trials == 0 || successes > trials) throw std::invalid_argument("share_interval: no such number of successes");
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  return {successes == 0 ? 0.0 : gsl_cdf_beta_Pinv(0.025, k, n - k + 1.0),
          successes == trials ? 1.0 : gsl_cdf_beta_Pinv(0.975, k + 1.0, n - k)};
}

MedianEstimate estimate_median(std::span<const BoundedSample> samples) {
  using Kind = BoundedSample::Kind;
  if (samples.empty()) throw std::invalid_argument("estimate_median: there is no sample");
  const auto count = [&](Kind kind) { return std::ranges::count(samples, kind, &BoundedSample::kind); };
  if (count(Kind::at_least) > 0 && count(Kind::at_most) > 0)
    throw std::invalid_argument("estimate_median: bounds on both sides");
  // The order of what is only bounded: beyond its bound lies anything, so for a lower end it counts with its bound, for
  // an upper end as infinite, and the other way round.
  const auto sorted = [&](Kind unbounded, double beyond) {
    std::vector<double> values;
    for (const BoundedSample& sample : samples) values.push_back(sample.kind == unbounded ? beyond : sample.value);
    std::ranges::sort(values);
    return values;
  };
  const std::vector<double> low = sorted(Kind::at_most, -infinity), high = sorted(Kind::at_least, infinity);
  const std::size_t size = samples.size();
  // The median lies above the k-th smallest value with probability P(Bin(n, 1/2) >= k).
  const auto rank = [&](double level) {
    unsigned below = 0;
    while (below < size && gsl_cdf_binomial_P(below, 0.5, static_cast<unsigned>(size)) <= level) ++below;
    return static_cast<std::size_t>(below);  // 0: no value bounds it
  };
  const auto ends = [&](double level) {
    const std::size_t k = rank(level);
    return std::pair{k == 0 ? -infinity : low[k - 1], k == 0 ? infinity : high[size - k]};
  };
  auto [lower, upper] = ends(0.025);
  if (!std::isfinite(lower) || !std::isfinite(upper)) {
    const auto [lower_alone, upper_alone] = ends(0.05);
    if (!std::isfinite(upper_alone) && std::isfinite(lower_alone))
      std::tie(lower, upper) = std::pair{lower_alone, infinity};
    if (!std::isfinite(lower_alone) && std::isfinite(upper_alone))
      std::tie(lower, upper) = std::pair{-infinity, upper_alone};
  }
  std::vector<double> values;
  for (const BoundedSample& sample : samples) values.push_back(sample.value);
  std::ranges::sort(values);
  return {0.5 * (values[(size - 1) / 2] + values[size / 2]), lower, upper};
}

double change_at_the_end(std::span<const double> values) {
  const std::size_t quarter = values.size() / 4;
  if (quarter < 2) return 0.0;
  const auto last = values.last(quarter);
  return average(last) - average(values.subspan(values.size() - 2 * quarter, quarter));
}

}  // namespace slfb
