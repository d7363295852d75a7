#include "experiments/numerics/convergence/grid_convergence.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slfb::convergence {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Celik et al. (2008), step 2.
constexpr double least_ratio = 1.3;
/// Roache's factor of safety for three and more grids.
constexpr double safety = 1.25;
/// No scheme has such an order: the two finest values agree by chance.
constexpr double largest_order = 10.0;
/// Part of the combinations that must behave alike [-].
constexpr double confidence = 0.95;
/// Quantiles of each value; an odd number has the mean itself among them.
constexpr int quantiles = 21;

struct Solution {
  Behaviour behaviour;
  double order = nothing, extrapolated = nothing;
};

/// (φ_3 − φ_2)/(φ_2 − φ_1) of a sequence of order p. It rises with p, from ln r_32/ln r_21.
double ratio_of_differences(double p, double log_r21, double log_r32) {
  return std::expm1(p * log_r32) / -std::expm1(-p * log_r21);
}

Solution solve(const std::array<double, 3>& size, const std::array<double, 3>& value) {
  const double fine = value[1] - value[0], coarse = value[2] - value[1];
  const double log_r21 = std::log(size[1] / size[0]), log_r32 = std::log(size[2] / size[1]);
  if (fine * coarse < 0.0) return {Behaviour::oscillates};
  if (fine == 0.0) return {Behaviour::undecided};
  const double ratio = coarse / fine;
  if (ratio <= log_r32 / log_r21) return {Behaviour::diverges};
  if (ratio >= ratio_of_differences(largest_order, log_r21, log_r32)) return {Behaviour::undecided};
  double low = 0.0, high = largest_order;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (ratio_of_differences(middle, log_r21, log_r32) < ratio ? low : high) = middle;
  }
  const double order = 0.5 * (low + high);
  return {Behaviour::converges, order, value[0] - fine / std::expm1(order * log_r21)};
}

double index_against(double value, double extrapolated) { return safety * std::abs((value - extrapolated) / value); }

std::pair<double, double> middle_95(std::vector<double>& values) {
  std::ranges::sort(values);
  const auto at = [&](double part) {
    return values[static_cast<std::size_t>(std::lround(part * static_cast<double>(values.size() - 1)))];
  };
  return {at(0.025), at(0.975)};
}

/// Each value's quantiles: the middles of equal parts of its distribution.
std::vector<double> quantiles_of(const Level& level) {
  if (level.half_width == 0.0) return {level.value};
  std::vector<double> values;
  const double deviation = level.half_width / gsl_cdf_ugaussian_Pinv(0.975);
  for (int k = 0; k < quantiles; ++k)
    values.push_back(level.value + deviation * gsl_cdf_ugaussian_Pinv((k + 0.5) / quantiles));
  return values;
}

}  // namespace

double GridConvergence::index_of(double value) const { return index_against(value, extrapolated); }

std::array<Level, 3> choose_levels(std::vector<Level> levels) {
  for (const Level& level : levels)
    if (!(level.size > 0.0)) throw std::invalid_argument(fmt::format("size {}: expected more than 0", level.size));
  std::ranges::sort(levels, {}, &Level::size);
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (levels[i].size == levels[i - 1].size)
      throw std::invalid_argument(fmt::format("two values of one size, {}", levels[i].size));
  if (levels.size() < 3)
    throw std::invalid_argument(fmt::format("{} sizes: an order needs three or more", levels.size()));
  std::vector<Level> chosen{levels.front()};
  for (const Level& level : levels)
    if (chosen.size() < 3 && level.size >= least_ratio * chosen.back().size) chosen.push_back(level);
  if (chosen.size() == 3) return {chosen[0], chosen[1], chosen[2]};
  const Level &finest = levels.front(), &coarsest = levels.back();
  const double middle = std::sqrt(finest.size * coarsest.size);
  const Level between = *std::min_element(levels.begin() + 1, levels.end() - 1, [&](const Level& a, const Level& b) {
    return std::abs(std::log(a.size / middle)) < std::abs(std::log(b.size / middle));
  });
  return {finest, between, coarsest};
}

GridConvergence analyse(const std::vector<Level>& levels) {
  GridConvergence found;
  found.levels = choose_levels(levels);
  const auto& [fine, middle, coarse] = found.levels;
  if (fine.value == 0.0) throw std::invalid_argument("an index relates to the finest value, which is 0");
  const auto [lowest, highest] = std::ranges::minmax(levels, {}, &Level::value);
  found.half_range = 0.5 * (highest.value - lowest.value) / std::abs(fine.value);
  for (const Level& a : levels)
    for (const Level& b : levels)
      found.differs = found.differs || std::abs(a.value - b.value) > std::hypot(a.half_width, b.half_width);
  // A single sample may lie anywhere: nothing can be said of how the values change.
  for (const Level& level : found.levels)
    if (!std::isfinite(level.half_width)) {
      found.shares.back() = 1.0;
      return found;
    }

  const std::array<double, 3> size{fine.size, middle.size, coarse.size};
  std::vector<double> orders, indices;
  double combinations = 0.0;
  for (const double a : quantiles_of(fine))
    for (const double b : quantiles_of(middle))
      for (const double c : quantiles_of(coarse)) {
        const Solution one = solve(size, {a, b, c});
        ++combinations;
        ++found.shares[static_cast<std::size_t>(one.behaviour)];
        if (one.behaviour != Behaviour::converges) continue;
        orders.push_back(one.order);
        indices.push_back(index_against(a, one.extrapolated));
      }
  for (std::size_t k = 0; k < found.shares.size(); ++k) {
    found.shares[k] /= combinations;
    if (found.shares[k] >= confidence) found.behaviour = static_cast<Behaviour>(k);
  }
  if (found.behaviour != Behaviour::converges) return found;
  const Solution of_means = solve(size, {fine.value, middle.value, coarse.value});
  found.order = of_means.order;
  found.extrapolated = of_means.extrapolated;
  found.index = index_against(fine.value, of_means.extrapolated);
  if (combinations > 1.0) {
    found.order_interval = middle_95(orders);
    found.index_interval = middle_95(indices);
  }
  return found;
}

std::string describe(const GridConvergence& found) {
  const std::string range = fmt::format("half of the range {:.2g} %", 100.0 * found.half_range);
  switch (found.behaviour) {
    case Behaviour::converges: {
      const auto interval = [](const std::optional<std::pair<double, double>>& of, double factor) {
        return of ? fmt::format(" ({:.2g} to {:.2g})", factor * of->first, factor * of->second) : "";
      };
      return fmt::format("order {:.2g}{}, index {:.2g}{} %", found.order, interval(found.order_interval, 1.0),
                         100.0 * found.index, interval(found.index_interval, 100.0));
    }
    case Behaviour::oscillates:
      return "not monotone, no order; " + range;
    case Behaviour::diverges:
      return "changes do not shrink, no order; " + range;
    case Behaviour::undecided:
      break;
  }
  return found.differs ? fmt::format("scatter hides the order ({:.0f} % of what it allows converges); {}",
                                     100.0 * found.shares.front(), range)
                       : "no difference beyond scatter; " + range;
}

}  // namespace slfb::convergence
