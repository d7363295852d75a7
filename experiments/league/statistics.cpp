#include "experiments/league/statistics.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace slfb::league {

double student_factor(double probability, std::size_t degrees) {
  return gsl_cdf_tdist_Pinv(0.5 + 0.5 * probability, static_cast<double>(degrees));
}

Statistic statistic_of(const std::vector<Comparison>& comparisons, double measured_spread) {
  if (comparisons.empty()) throw std::invalid_argument("statistic_of: no comparisons");
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  struct Sums {
    double count = 0.0, sum = 0.0, squares = 0.0;
  };
  std::map<std::string, Sums> sums;
  for (const Comparison& one : comparisons) {
    Sums& group = sums[one.group];
    group.count += 1.0;
    group.sum += one.log_ratio;
    group.squares += one.log_ratio * one.log_ratio;
  }
  Statistic result;
  result.points = comparisons.size();
  result.groups = sums.size();
  result.measured_spread = measured_spread;
  const auto groups = static_cast<double>(sums.size());
  double square = 0.0, square_of_means = 0.0;
  for (const auto& [name, group] : sums) {
    const double mean = group.sum / group.count;
    result.mean += mean / groups;
    square += group.squares / group.count / groups;
    square_of_means += mean * mean / groups;
  }
  result.root_mean_square = std::sqrt(square);
  if (sums.size() < 2) {
    result.mean_half_width = result.total_spread = result.spread = result.spread_lower = result.spread_upper = unknown;
    result.bias = std::exp(result.mean);
    return result;
  }
  const double degrees = groups - 1.0;
  const double between = std::max(0.0, square_of_means - result.mean * result.mean) * groups / degrees;
  const double total = std::max(0.0, square - result.mean * result.mean) * groups / degrees;
  const double measured = measured_spread * measured_spread;
  const auto of_law = [&](double variance) { return std::sqrt(std::max(0.0, variance - measured)); };
  result.mean_half_width = student_factor(0.95, sums.size() - 1) * std::sqrt(between / groups);
  result.total_spread = std::sqrt(total);
  result.spread = of_law(total);
  result.spread_lower = of_law(total * degrees / gsl_cdf_chisq_Pinv(0.975, degrees));
  result.spread_upper = of_law(total * degrees / gsl_cdf_chisq_Pinv(0.025, degrees));
  result.bias = std::exp(result.mean + 0.5 * result.spread * result.spread - 0.5 * measured);
  return result;
}

}  // namespace slfb::league
