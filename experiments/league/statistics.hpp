#pragma once

#include <string>
#include <vector>

/// How far a law is from measurements, as validation of fire models states it: a bias and a spread that are relative,
/// with the uncertainty of the measurements taken out (McGrattan & Toman 2011, Metrologia 48, 173; NIST SP 1018-3).
namespace slfb::league {

/// A law beside one measurement.
struct Comparison {
  std::string group;  ///< measurements that share errors: the same spheres in the same liquid, or one author
  double log_ratio;   ///< ln(law / measured) [-]
};

/// What the comparisons say of a law. Every group has the same weight, and groups are taken as independent; what lies
/// in one group is not.
struct Statistic {
  std::size_t points = 0, groups = 0;
  double mean = 0.0;             ///< of ln(law / measured) [-]
  double mean_half_width = 0.0;  ///< of its 95 % interval, Student's t over the groups; NaN for one group
  /// Standard deviation of ln(law / measured), measurement included [-]; NaN for one group.
  double total_spread = 0.0;
  double measured_spread = 0.0;  ///< σ_E, relative standard deviation of the measurements [-]
  double spread = 0.0;           ///< σ_M of the law: √(total² − σ_E²), 0 where the measurements explain all [-]
  double spread_lower = 0.0, spread_upper = 0.0;  ///< 95 % interval of `spread`, chi-square over the groups
  double bias = 1.0;                              ///< δ = exp(mean + σ_M²/2 − σ_E²/2): law over truth [-]
  double root_mean_square = 0.0;                  ///< of ln(law / measured), bias included [-]
};

/// \param measured_spread σ_E [-]. \throws std::invalid_argument without comparisons
Statistic statistic_of(const std::vector<Comparison>& comparisons, double measured_spread);

/// Two-sided Student's t of that probability, as a number of standard deviations: 0.95 gives 2.26 for 9 degrees.
double student_factor(double probability, std::size_t degrees);

}  // namespace slfb::league
