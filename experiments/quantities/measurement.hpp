#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/quantities/measure_key.hpp"

namespace slfb {

/// Of the runs behind a number that hangs on them: those of the scene, or softened ones.
enum class Springs { any, own, softened };

/// A measured number with its 95 % confidence interval.
struct Measurement {
  double value = std::numeric_limits<double>::quiet_NaN();
  double half_width = 0.0;  ///< of the 95 % interval; 0 for a deterministic result, NaN for a single sample
  std::size_t samples = 1;  ///< independent samples (replicates, or effective ones of a correlated series)
  std::string unit = {};
  std::string origin = {};  ///< what produced it: "law", "arithmetic", or the name of the run
  Springs springs = Springs::any;
  /// The 95 % interval where it is not value ± half_width: of a share, or of a median of drops some of which were still
  /// on their way when they were last seen. An open side is ±infinity.
  std::optional<std::pair<double, double>> interval = {};
  double scatter = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation of one drop; NaN: unknown
  double lowest = -std::numeric_limits<double>::infinity();   ///< bounds of nature: a count is not below 0
  double highest = std::numeric_limits<double>::infinity();
  bool steady = true;       ///< false: of beds that still changed when they were measured
  std::string remark = {};  ///< what a reader has to know of it: "none of 5 drops arrived"

  /// Ends of the 95 % interval within the bounds of nature; NaN for a single sample.
  [[nodiscard]] double lower() const;
  [[nodiscard]] double upper() const;
  [[nodiscard]] bool has_interval() const;
};

using Measurements = std::map<MeasureKey, Measurement>;

/// The measurements of a quantity of one subject and detail by their number `at`, which rises.
std::map<double, Measurement> over_numbers(const Measurements& measurements, std::string_view quantity,
                                           std::string_view subject, std::string_view detail = "");

}  // namespace slfb
