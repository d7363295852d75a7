#include "experiments/readings/emulator.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slfb::readings {
namespace {

/// Variances tried, over that of the values: from "all is chance" to "one level moves it all".
constexpr std::array tried_terms{0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0};
constexpr std::array tried_left_over{1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0};
/// The constant is as good as free.
constexpr double constant_over_values = 10.0;

}  // namespace

Emulator::Emulator(const std::vector<Reading>& readings, std::span<const double> values,
                   std::span<const double> variances) {
  const auto size = static_cast<Eigen::Index>(readings.size());
  if (size < 3 || values.size() != readings.size() || variances.size() != readings.size())
    throw std::invalid_argument("Emulator: needed are three readings or more, with a value and a variance for each");
  std::ptrdiff_t next = 0;
  columns_.resize(readings.front().size());
  for (const Reading& reading : readings)
    for (std::size_t f = 0; f < reading.size(); ++f) {
      auto& levels = columns_[f];
      if (levels.size() <= reading[f]) levels.resize(reading[f] + 1, -1);
      if (levels[reading[f]] < 0) levels[reading[f]] = next++;
    }
  // Which terms a reading has; the last column is the constant.
  Eigen::MatrixXd has = Eigen::MatrixXd::Zero(size, next + 1);
  for (Eigen::Index r = 0; r < size; ++r) {
    const Reading& reading = readings[static_cast<std::size_t>(r)];
    for (std::size_t f = 0; f < reading.size(); ++f) has(r, column(f, reading[f])) = 1.0;
    has(r, next) = 1.0;
  }
  values_ = Eigen::Map<const Eigen::VectorXd>(values.data(), size);
  mean_ = values_.mean();
  values_.array() -= mean_;
  const Eigen::VectorXd chance = Eigen::Map<const Eigen::VectorXd>(variances.data(), size);
  const double spread =
      std::max(values_.squaredNorm() / static_cast<double>(size - 1), std::numeric_limits<double>::min());
  constant_variance_ = constant_over_values * spread;

  const Eigen::MatrixXd shared = has.leftCols(next) * has.leftCols(next).transpose();
  const auto covariance = [&](double term, double left_over) {
    Eigen::MatrixXd matrix = term * shared;
    matrix.array() += constant_variance_;
    matrix.diagonal() += chance;
    // Round-off of the spread keeps the matrix regular where two readings agree and chance is nought.
    matrix.diagonal().array() += left_over + 1e-9 * spread;
    return matrix;
  };
  double best = -std::numeric_limits<double>::infinity();
  for (const double term : tried_terms)
    for (const double left_over : tried_left_over) {
      const Eigen::LLT<Eigen::MatrixXd> factor(covariance(term * spread, left_over * spread));
      const double log_likelihood =
          -0.5 * values_.dot(factor.solve(values_)) - factor.matrixLLT().diagonal().array().log().sum();
      if (log_likelihood > best) {
        best = log_likelihood;
        term_variance_ = term * spread;
        left_over_variance_ = left_over * spread;
      }
    }
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance(term_variance_, left_over_variance_));
  inverse_ = factor.solve(Eigen::MatrixXd::Identity(size, size));
  weights_ = inverse_ * values_;
  Eigen::MatrixXd scaled = has;  // covariance of the values with the terms
  scaled.leftCols(next) *= term_variance_;
  scaled.col(next) *= constant_variance_;
  terms_ = scaled.transpose() * weights_;
  known_ = scaled.transpose() * inverse_ * scaled;
}

std::ptrdiff_t Emulator::column(std::size_t factor, std::size_t level) const {
  const auto& levels = columns_[factor];
  return level < levels.size() ? levels[level] : -1;
}

Emulator::Prediction Emulator::predict(const Reading& reading) const {
  const Eigen::Index constant = terms_.size() - 1;
  Prediction prediction{mean_ + terms_[constant],
                        constant_variance_ + left_over_variance_ - known_(constant, constant)};
  for (std::size_t f = 0; f < reading.size(); ++f) {
    prediction.variance += term_variance_;
    const std::ptrdiff_t a = column(f, reading[f]);
    if (a < 0) continue;  // a level that was never tried: nothing is known of its term
    prediction.mean += terms_[a];
    prediction.variance -= known_(a, a) + 2.0 * known_(a, constant);
    for (std::size_t g = 0; g < f; ++g)
      if (const std::ptrdiff_t b = column(g, reading[g]); b >= 0) prediction.variance -= 2.0 * known_(a, b);
  }
  prediction.variance = std::max(prediction.variance, 0.0);
  return prediction;
}

Emulator::Prediction Emulator::predict_without(std::size_t place) const {
  const auto r = static_cast<Eigen::Index>(place);
  const double variance = 1.0 / inverse_(r, r);
  return {mean_ + values_[r] - weights_[r] * variance, variance};
}

double Emulator::effect(std::size_t factor, std::size_t level) const {
  const std::ptrdiff_t place = column(factor, level);
  return place < 0 ? 0.0 : terms_[place];
}

double Emulator::left_over() const { return std::sqrt(left_over_variance_); }

}  // namespace slfb::readings
