#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "experiments/readings/choices.hpp"

namespace slfb::readings {

/// A number as a function of the levels of a reading: a constant, one term for each level of each factor, and what is
/// left over. All terms are normal with mean 0: those of levels with one variance, what is left over with another. Both
/// variances are those under which the values are most likely (Gaussian process with an additive kernel over
/// categories; Rasmussen & Williams 2006, Gaussian Processes for Machine Learning, sections 2.2 and 5.4.1).
class Emulator {
 public:
  struct Prediction {
    double mean = 0.0;
    double variance = 0.0;  ///< of the number under that reading, without chance
  };

  /// \param readings at least three, all with the same number of factors
  /// \param values of the number, one for each reading
  /// \param variances by chance, of each value; not negative
  /// Throws std::invalid_argument for fewer readings, or lengths that differ.
  Emulator(const std::vector<Reading>& readings, std::span<const double> values, std::span<const double> variances);

  [[nodiscard]] Prediction predict(const Reading& reading) const;
  /// Without the reading with this place.
  [[nodiscard]] Prediction predict_without(std::size_t place) const;
  /// The term of a level; 0 for one that no reading has.
  [[nodiscard]] double effect(std::size_t factor, std::size_t level) const;
  /// Standard deviation of what is left over beside the sum of terms.
  [[nodiscard]] double left_over() const;

 private:
  /// Column of the terms for a level of a factor; none when no reading has it.
  [[nodiscard]] std::ptrdiff_t column(std::size_t factor, std::size_t level) const;

  std::vector<std::vector<std::ptrdiff_t>> columns_;  // by factor and level
  Eigen::VectorXd values_;                            // about their mean
  double mean_ = 0.0;
  double term_variance_ = 0.0, left_over_variance_ = 0.0, constant_variance_ = 0.0;
  Eigen::MatrixXd inverse_;  // of the covariance of the values
  Eigen::VectorXd weights_;  // inverse times values
  Eigen::VectorXd terms_;    // of the levels, and the constant behind them
  Eigen::MatrixXd known_;    // what the values say of the terms: the prior's variance is less by this
};

}  // namespace slfb::readings
