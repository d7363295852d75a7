#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>

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

/// Keys read "<quantity>/<system>/<U_L>", e.g. "classification_velocity/6in5W/0.06"; a variant follows after a
/// further slash ("…/0.06/di-felice-1994"). Quantities that need no run: "<quantity>/<what>".
using Measurements = std::map<std::string, Measurement>;

}  // namespace slfb
