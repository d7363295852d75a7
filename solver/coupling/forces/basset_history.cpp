#include "solver/coupling/forces/basset_history.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace slfb::coupling {

double basset_coefficient(double diameter, LiquidProperties liquid) {
  return 1.5 * diameter * diameter * std::sqrt(std::numbers::pi * liquid.density * liquid.viscosity);
}

BassetHistory::BassetHistory(double time_step, std::size_t window)
    : time_step_(time_step),
      weight_(2.0 / std::sqrt(time_step)),
      window_(window),
      stride_(3 * axis_stride() + 1),
      kernel_(2 * window) {
  if (!(time_step > 0.0) || window == 0) throw std::invalid_argument("Basset history: no time step or no window");
  // Mean of 1/√age over the step of that age.
  for (std::size_t k = 0; k < 2 * window; ++k) {
    const auto age = static_cast<double>(k % window);
    kernel_[k] = weight_ * (std::sqrt(age + 1.0) - std::sqrt(age));
  }
  fit_tail();
}

/// Least squares for the relative error over ages of 1 to 1e4 windows; rates in geometric progression. The end rates, 2
/// and 0.3e-4 per window, are those that make the largest error smallest.
void BassetHistory::fit_tail() {
  constexpr int samples = 400;
  constexpr double range = 1e4, fastest = 2.0, slowest = 0.3 / range;
  const double length = static_cast<double>(window_) * time_step_;
  Eigen::Matrix<double, Eigen::Dynamic, modes> values(samples, modes);
  for (std::size_t j = 0; j < modes; ++j) {
    const double rate = fastest * std::pow(slowest / fastest, static_cast<double>(j) / (modes - 1));
    rate_[j] = rate / length;
    for (int k = 0; k < samples; ++k) {
      const double age = std::pow(range, static_cast<double>(k) / (samples - 1));
      values(k, static_cast<Eigen::Index>(j)) = std::exp(-rate * age) * std::sqrt(age);
    }
  }
  const Eigen::Vector<double, modes> weights = values.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(samples));
  for (std::size_t j = 0; j < modes; ++j) {
    tail_weight_[j] = weights[static_cast<Eigen::Index>(j)] / std::sqrt(length);
    decay_[j] = std::exp(-rate_[j] * time_step_);
    // Mean over the step that has just become older than the window.
    entry_[j] =
        tail_weight_[j] * std::exp(-rate_[j] * length) * -std::expm1(-rate_[j] * time_step_) / (rate_[j] * time_step_);
  }
}

double BassetHistory::tail_kernel(double age) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < modes; ++j) sum += tail_weight_[j] * std::exp(-rate_[j] * age);
  return sum;
}

void BassetHistory::add(Vec3 slip) {
  const std::size_t begin = state_.size();
  state_.resize(begin + stride_, 0.0);
  const std::array<double, 3> components{slip.x, slip.y, slip.z};
  for (std::size_t a = 0; a < 3; ++a) {
    double* const axis = &state_[begin + a * axis_stride()];
    axis[window_ + modes] = axis[window_ + modes + 1] = components[a];
  }
}

void BassetHistory::remove(std::size_t i) {
  const auto begin = state_.begin() + static_cast<std::ptrdiff_t>(i * stride_);
  state_.erase(begin, begin + static_cast<std::ptrdiff_t>(stride_));
}

void BassetHistory::restore(State state) {
  if (state.spheres.size() % stride_ != 0 || state.newest >= window_)
    throw std::invalid_argument("Basset history: the state is of another window");
  state_ = std::move(state.spheres);
  newest_ = state.newest;
}

Vec3 BassetHistory::memory(std::size_t i) const {
  const double* const sphere = &state_[i * stride_];
  const double age = (sphere[3 * axis_stride()] + 1.0) * time_step_;
  // The ring turns backwards: the oldest change, which the step under way will push out, stands at newest_, and the one
  // of the last step behind it, at the second place of the kernel.
  const std::size_t oldest = newest_;
  std::array<double, 3> sum{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double* const axis = sphere + a * axis_stride();
    const double* const mode = axis + window_;
    const double* const kernel = &kernel_[window_ - oldest];
    double total = 0.0;
    for (std::size_t k = 0; k < window_; ++k) total += kernel[k] * axis[k];
    total -= kernel_[0] * axis[oldest];
    for (std::size_t j = 0; j < modes; ++j) total += decay_[j] * mode[j] + entry_[j] * axis[oldest];
    sum[a] = total - weight_ * mode[modes] + mode[modes + 1] / std::sqrt(age);
  }
  return {sum[0], sum[1], sum[2]};
}

void BassetHistory::advance(std::size_t i, Vec3 slip) {
  double* const sphere = &state_[i * stride_];
  const std::array<double, 3> components{slip.x, slip.y, slip.z};
  for (std::size_t a = 0; a < 3; ++a) {
    double* const axis = sphere + a * axis_stride();
    double* const mode = axis + window_;
    for (std::size_t j = 0; j < modes; ++j) mode[j] = decay_[j] * mode[j] + entry_[j] * axis[newest_];
    axis[newest_] = components[a] - mode[modes];
    mode[modes] = components[a];
  }
  sphere[3 * axis_stride()] += 1.0;
}

}  // namespace slfb::coupling
