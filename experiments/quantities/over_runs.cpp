#include "experiments/quantities/over_runs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slfb {
namespace {

Measurement measured(double value, double half_width, std::size_t samples) {
  return {.value = value, .half_width = half_width, .samples = samples, .unit = "", .origin = ""};
}

/// Of the least-squares line through the values, from the first abscissa to the last, over `mean`.
Measurement rise_over_mean(const std::vector<double>& x, const std::vector<Measurement>& values, double mean) {
  double middle = 0.0, squares = 0.0;
  for (const double at : x) middle += at / static_cast<double>(x.size());
  for (const double at : x) squares += (at - middle) * (at - middle);
  LinearNumber rise;
  for (std::size_t k = 0; k < x.size(); ++k)
    rise.add((x[k] - middle) / squares * (x.back() - x.front()) / mean, values[k]);
  return measured(rise.value, std::sqrt(rise.variance), values.size());
}

}  // namespace

void LinearNumber::add(double weight, const Measurement& term) {
  value += weight * term.value;
  variance += weight * weight * term.half_width * term.half_width;
}

PressureCurve pressure_curve(const std::map<double, Measurement>& pressures, double packed_up_to,
                             double fluidised_from) {
  std::vector<double> velocities, fluidised_velocities;
  std::vector<Measurement> packed, fluidised;
  for (const auto& [velocity, pressure] : pressures) {
    if (velocity < packed_up_to) {
      velocities.push_back(velocity);
      packed.push_back(pressure);
    } else if (velocity > fluidised_from && !std::isnan(pressure.half_width)) {
      // A bed that was not steady, or measured too briefly for an interval, is no point of a mean that has one.
      fluidised_velocities.push_back(velocity);
      fluidised.push_back(pressure);
    }
  }
  PressureCurve curve;
  LinearNumber plateau;
  for (const Measurement& pressure : fluidised) plateau.add(1.0 / static_cast<double>(fluidised.size()), pressure);
  if (!fluidised.empty()) curve.plateau = measured(plateau.value, std::sqrt(plateau.variance), fluidised.size());
  if (fluidised.size() >= 3) curve.plateau_rise = rise_over_mean(fluidised_velocities, fluidised, plateau.value);
  if (packed.size() < 2) return curve;

  // Least squares as weights of the points, so that their intervals carry over to the line and the crossing.
  const auto size = static_cast<double>(packed.size());
  double mean = 0.0, squares = 0.0;
  for (const double velocity : velocities) mean += velocity / size;
  for (const double velocity : velocities) squares += (velocity - mean) * (velocity - mean);
  LinearNumber slope, intercept;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const double weight = (velocities[i] - mean) / squares;
    slope.add(weight, packed[i]);
    intercept.add(1.0 / size - mean * weight, packed[i]);
  }
  curve.slope = measured(slope.value, std::sqrt(slope.variance), packed.size());
  curve.intercept = measured(intercept.value, std::sqrt(intercept.variance), packed.size());
  if (fluidised.empty()) return curve;

  const double crossing = (plateau.value - intercept.value) / slope.value;
  LinearNumber error;  // of plateau − intercept − crossing · slope, first order
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const double weight = (velocities[i] - mean) / squares;
    error.add(1.0 / size - mean * weight + crossing * weight, packed[i]);
  }
  curve.crossing = measured(crossing, std::sqrt(plateau.variance + error.variance) / std::abs(slope.value),
                            packed.size() + fluidised.size());
  return curve;
}

std::optional<Measurement> value_at_voidage(const std::map<double, Measurement>& voidages,
                                            const std::map<double, Measurement>& values, double stated,
                                            double tolerance) {
  struct Point {
    Measurement voidage, value;
  };
  std::vector<Point> points;
  for (const auto& [velocity, value] : values)
    if (const auto voidage = voidages.find(velocity); voidage != voidages.end())
      points.push_back({voidage->second, value});
  if (points.empty()) return std::nullopt;
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.voidage.value < b.voidage.value; });
  const auto above =
      std::find_if(points.begin(), points.end(), [&](const Point& point) { return point.voidage.value >= stated; });
  const Point& upper = above == points.end() ? points.back() : *above;
  const Point& lower = above == points.begin() || above == points.end() ? upper : *(above - 1);
  const double extent = upper.voidage.value - lower.voidage.value;
  if (!(extent > 0.0) && std::abs(upper.voidage.value - stated) > tolerance) return std::nullopt;
  const double share = extent > 0.0 ? (stated - lower.voidage.value) / extent : 1.0;
  const double slope = extent > 0.0 ? (upper.value.value - lower.value.value) / extent : 0.0;
  LinearNumber result;
  result.add(1.0 - share, lower.value);
  if (share > 0.0) result.add(share, upper.value);
  result.variance += std::pow(slope * std::max(lower.voidage.half_width, upper.voidage.half_width), 2);
  Measurement answer =
      measured(result.value, std::sqrt(result.variance), std::min(lower.value.samples, upper.value.samples));
  answer.unit = upper.value.unit;
  answer.lowest = upper.value.lowest;
  answer.highest = upper.value.highest;
  answer.scatter = share > 0.0 ? std::lerp(lower.value.scatter, upper.value.scatter, share) : lower.value.scatter;
  answer.steady = lower.value.steady && upper.value.steady;
  answer.remark = lower.value.remark.empty() ? upper.value.remark : lower.value.remark;
  return answer;
}

}  // namespace slfb
