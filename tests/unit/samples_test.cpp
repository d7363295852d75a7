#include "experiments/quantities/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace slfb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Beds = std::vector<std::vector<double>>;

// Three beds that differ by ten times what their drops scatter: nine drops are no nine samples. Student's t of two
// degrees of freedom is 4.3027, the standard error of the bed means 1, 2, 3 is 1/√3.
TEST(PoolBeds, BedsThatDifferAreTheSamples) {
  const PooledEstimate estimate = pool_beds(Beds{{0.9, 1.0, 1.1}, {1.9, 2.0, 2.1}, {2.9, 3.0, 3.1}});
  EXPECT_EQ(estimate.samples, 3U);
  EXPECT_NEAR(estimate.mean, 2.0, 1e-12);
  EXPECT_NEAR(estimate.half_width, 4.302653 / std::sqrt(3.0), 1e-5);
  // One drop scatters by the variance within, 0.01, and by that of the beds, (3 − 0.01)/3.
  EXPECT_NEAR(estimate.scatter, std::sqrt(0.01 + 2.99 / 3.0), 1e-9);
}

TEST(PoolBeds, BedsThatDoNotDifferArePooled) {
  const PooledEstimate estimate = pool_beds(Beds{{1.0, 2.0, 3.0}, {1.1, 2.0, 2.9}});
  EXPECT_EQ(estimate.samples, 6U);
  EXPECT_NEAR(estimate.mean, 2.0, 1e-12);
  EXPECT_LT(estimate.half_width, 1.0);
}

TEST(PoolBeds, ASingleDropHasNoIntervalAndNoDropNoMean) {
  EXPECT_TRUE(std::isnan(pool_beds(Beds{{1.0}}).half_width));
  EXPECT_EQ(pool_beds(Beds{{}, {1.0, 3.0}}).samples, 2U);
  EXPECT_THROW(pool_beds(Beds{{}}), std::invalid_argument);
}

// Counts of a Poisson process of mean 2.3: three of them are equal by chance now and then. Their interval has width
// zero then and misses; with the scatter of the rounding it holds the mean as often as is said.
TEST(PoolBeds, EqualCountsAreNotKnownExactly) {
  EXPECT_EQ(pool_beds(Beds{{2.0, 2.0, 2.0}}).half_width, 0.0);
  const PooledEstimate equal = with_resolution(pool_beds(Beds{{2.0, 2.0, 2.0}}), 1.0);
  EXPECT_NEAR(equal.half_width, 4.3027 / std::sqrt(12.0) / std::sqrt(3.0),
              1e-4);  // Student's t, two degrees of freedom
  std::mt19937 random(5);
  std::poisson_distribution<int> count(2.3);
  int raw = 0, kept = 0;
  constexpr int trials = 4000;
  for (int k = 0; k < trials; ++k) {
    Beds beds{{}};
    for (int n = 0; n < 3; ++n) beds[0].push_back(count(random));
    const PooledEstimate estimate = pool_beds(beds), resolved = with_resolution(estimate, 1.0);
    raw += std::abs(estimate.mean - 2.3) <= estimate.half_width;
    kept += std::abs(resolved.mean - 2.3) <= resolved.half_width;
  }
  EXPECT_LT(raw, 0.93 * trials);
  EXPECT_GT(kept, 0.95 * trials);
}

TEST(PoolBeds, ScatterOfManyDropsIsNotRounded) {
  const PooledEstimate estimate = pool_beds(Beds{{1.0, 5.0, 3.0, 7.0}});
  EXPECT_EQ(with_resolution(estimate, 1.0).half_width, estimate.half_width);
  EXPECT_TRUE(std::isnan(with_resolution(pool_beds(Beds{{2.0}}), 1.0).half_width));
}

// The interval holds the true mean about as often as it says, whether beds differ by nothing or by more than drops do.
// Drops that are all taken for independent hold it in two of three cases there.
TEST(PoolBeds, CoversTheMeanWhateverTheBedsAdd) {
  std::mt19937 random(3);
  for (const double of_beds : {0.0, 0.5, 1.0, 3.0}) {
    std::normal_distribution<double> bed(0.0, 1.0), drop(0.0, 1.0);
    int held = 0;
    constexpr int trials = 4000;
    for (int trial = 0; trial < trials; ++trial) {
      Beds beds(4);
      for (auto& drops : beds) {
        const double offset = of_beds * bed(random);
        for (int k = 0; k < 4; ++k) drops.push_back(offset + drop(random));
      }
      const PooledEstimate estimate = pool_beds(beds);
      held += std::abs(estimate.mean) <= estimate.half_width;
    }
    EXPECT_GT(held, 0.88 * trials) << of_beds;
    EXPECT_LT(held, 0.98 * trials) << of_beds;
  }
}

SeriesEstimate series(double mean, double half_width) { return {mean, half_width, 1.0, 50.0, 0}; }

// Two beds of 1450 ± 2 and 1451 ± 1 Pa agree: the weights are 1 to 4. 1450 ± 2 and 1456 ± 1 Pa do not: two samples.
TEST(PoolSeries, WeightsWhatAgreesAndTakesTheScatterOfWhatDoesNot) {
  const std::vector agree{series(1450.0, 2.0), series(1451.0, 1.0)};
  EXPECT_NEAR(pool_series(agree).mean, 1450.8, 1e-9);
  EXPECT_NEAR(pool_series(agree).half_width, std::sqrt(0.8), 0.02);
  const std::vector differ{series(1450.0, 2.0), series(1456.0, 1.0)};
  EXPECT_NEAR(pool_series(differ).mean, 1453.0, 1e-9);
  EXPECT_NEAR(pool_series(differ).half_width, 12.7062 * 3.0, 1e-3);
  EXPECT_EQ(pool_series(differ).samples, 2U);
}

TEST(PoolSeries, ASeriesWithoutAnIntervalCountsOnlyAlone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(pool_series(std::vector{series(1450.0, none), series(1460.0, 1.0)}).mean, 1460.0, 1e-12);
  EXPECT_TRUE(std::isnan(pool_series(std::vector{series(1450.0, none)}).half_width));
}

// Published intervals of Clopper & Pearson: 0 of 5 and 5 of 10.
TEST(ShareInterval, OfPublishedCounts) {
  EXPECT_NEAR(share_interval(0, 5).second, 0.5218, 1e-4);
  EXPECT_EQ(share_interval(0, 5).first, 0.0);
  EXPECT_NEAR(share_interval(5, 10).first, 0.1871, 1e-4);
  EXPECT_NEAR(share_interval(5, 10).second, 0.8129, 1e-4);
  EXPECT_EQ(share_interval(6, 6).second, 1.0);
  EXPECT_GT(share_interval(6, 6).first, 0.5);
  EXPECT_THROW(share_interval(2, 1), std::invalid_argument);
}

std::vector<BoundedSample> none_arrived(std::size_t count) {
  return std::vector<BoundedSample>(count, {15.0, BoundedSample::Kind::at_least});
}

// None of n arrived in 15 s: were half of all there by then, that would be as likely as 2^-n, below 5 % from n = 5.
TEST(Median, OfDropsThatDidNotArriveHasALowerEnd) {
  EXPECT_EQ(estimate_median(none_arrived(5)).lower, 15.0);
  EXPECT_EQ(estimate_median(none_arrived(5)).upper, infinity);
  EXPECT_EQ(estimate_median(none_arrived(4)).lower, -infinity);
}

TEST(Median, OfSomeThatArrivedLiesBetweenThem) {
  std::vector<BoundedSample> samples = none_arrived(2);
  for (const double time : {3.0, 4.0, 5.0, 6.0, 7.0, 8.0}) samples.push_back({time});
  const MedianEstimate estimate = estimate_median(samples);
  EXPECT_DOUBLE_EQ(estimate.value, 6.5);
  // Of eight, one or none lies below the median in 9 of 256 cases: the second is below it at 95 %.
  EXPECT_EQ(estimate.lower, 4.0);
  EXPECT_EQ(estimate.upper, infinity);
}

TEST(Median, KnowsNoBoundsOnBothSides) {
  EXPECT_THROW(estimate_median({}), std::invalid_argument);
  const std::vector<BoundedSample> both{{1.0, BoundedSample::Kind::at_least}, {2.0, BoundedSample::Kind::at_most}};
  EXPECT_THROW(estimate_median(both), std::invalid_argument);
}

TEST(ChangeAtTheEnd, OfALineAndOfAConstant) {
  std::vector<double> rising, steady(40, 2.0);
  for (int k = 0; k < 40; ++k) rising.push_back(0.1 * k);
  EXPECT_NEAR(change_at_the_end(rising), 1.0, 1e-12);
  EXPECT_EQ(change_at_the_end(steady), 0.0);
}

}  // namespace
}  // namespace slfb
