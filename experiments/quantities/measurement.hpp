#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "experiments/quantities/measure_key.hpp"

namespace slfb {

/// Of the runs behind a number that hangs on them: those of the scene, or softened ones.
enum class Springs { any, own, softened };

/// A measured number with its 95 % confidence interval.
struct Measurement {
  double value = std::numeric_limits<double>::quiet_NaN();
  double half_width = 0.0;  ///< of the 95 % interval; 0 for a deterministic result, NaN for a single sample
  std::size_t samples = 1;  ///< independent samples (replicates, or effective ones of a correlated series)
  std::string unit;
  std::string origin;  ///< what produced it: "law", "arithmetic", or the name of the run
  Springs springs = Springs::any;
};

using Measurements = std::map<MeasureKey, Measurement>;

/// The measurements of a quantity of one subject and detail by their number `at`, which rises.
std::map<double, Measurement> over_numbers(const Measurements& measurements, std::string_view quantity,
                                           std::string_view subject, std::string_view detail = "");

}  // namespace slfb
