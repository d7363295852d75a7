#include "experiments/commands/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slfb {
namespace {

constexpr double exact = 1e-9;  // relative

bool differ(const Measurement& one, const Measurement& other) {
  const double allowed = one.half_width + other.half_width;
  return std::fabs(one.value - other.value) > std::max(allowed, exact * std::fabs(other.value));
}

}  // namespace

void gate_against_baseline(std::vector<Evaluation>& evaluations, const Measurements& now,
                           const Measurements& accepted) {
  for (Evaluation& evaluation : evaluations) {
    evaluation.gate = Gate::none;
    for (const auto& [key, measured] : now) {
      const auto before = accepted.find(key);
      if (before == accepted.end() || std::isnan(measured.half_width) || std::isnan(before->second.half_width) ||
          std::ranges::none_of(evaluation.claim.measures,
                               [&key = key](const MeasureKey& measure) { return stands_for(measure, key); }))
        continue;
      if (differ(measured, before->second)) {
        evaluation.gate = Gate::broken;
        evaluation.reason +=
            fmt::format("; {} is {:.6g} ± {:.2g}, accepted was {:.6g} ± {:.2g}", to_string(key), measured.value,
                        measured.half_width, before->second.value, before->second.half_width);
      } else if (evaluation.gate == Gate::none) {
        evaluation.gate = Gate::holds;
      }
    }
  }
}

}  // namespace slfb
