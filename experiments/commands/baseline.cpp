#include "experiments/commands/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace slfb {
namespace {

constexpr double exact = 1e-9;  // relative

/// Their intervals do not meet.
bool differ(const Measurement& one, const Measurement& other) {
  const double allowed = exact * std::fabs(other.value);
  return one.lower() > other.upper() + allowed || one.upper() < other.lower() - allowed;
}

std::string value_text(const Measurement& measured) {
  return measured.interval
             ? fmt::format("{:.6g} in [{:.6g}, {:.6g}]", measured.value, measured.lower(), measured.upper())
             : fmt::format("{:.6g} ± {:.2g}", measured.value, measured.half_width);
}

}  // namespace

void gate_against_baseline(std::vector<Evaluation>& evaluations, const Measurements& now,
                           const Measurements& accepted) {
  for (Evaluation& evaluation : evaluations) {
    evaluation.gate = Gate::none;
    for (const auto& [key, measured] : now) {
      const auto before = accepted.find(key);
      if (before == accepted.end() || !measured.has_interval() || !before->second.has_interval() ||
          std::ranges::none_of(evaluation.claim.measures,
                               [&key = key](const MeasureKey& measure) { return stands_for(measure, key); }))
        continue;
      if (differ(measured, before->second)) {
        evaluation.gate = Gate::broken;
        evaluation.reason += fmt::format("; {} is {}, accepted was {}", to_string(key), value_text(measured),
                                         value_text(before->second));
      } else if (evaluation.gate == Gate::none) {
        evaluation.gate = Gate::holds;
      }
    }
  }
}

}  // namespace slfb
